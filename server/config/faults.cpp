// Faults of configuration files.
#include "config/faults.hpp"

namespace foothold::server {
namespace {

std::string joined(const std::vector<std::string>& sentences) {
  std::string all;
  for (const auto& sentence : sentences) all += (all.empty() ? "" : "\n") + sentence;
  return all;
}

}  // namespace

void Faults::add(const std::string& file, int line, const std::string& field, const std::string& reason) {
  sentences_.push_back(file + ":" + (line > 0 ? std::to_string(line) + ":" : "") + " " + (field.empty() ? "" : field + ": ") +
                       reason);
}

void Faults::add(const Faults& others) { sentences_.insert(sentences_.end(), others.sentences_.begin(), others.sentences_.end()); }

ConfigError::ConfigError(const Faults& faults) : std::runtime_error(joined(faults.sentences())), faults_(faults.sentences()) {}

}  // namespace foothold::server
