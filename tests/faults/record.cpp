// See record.hpp.
#include "record.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace foothold::faults {

void note(const std::string& file, const msg::Id& id, const Outcome& outcome) {
  std::ostringstream line;
  line << msg::to_hex(id) << ' ' << outcome.kind << ' ' << outcome.robot << ' ' << outcome.state << ' ' << outcome.code << ' '
       << outcome.steps << ' ' << (outcome.chain.empty() ? "-" : outcome.chain) << ' ' << outcome.reason << '\n';
  const std::string text = line.str();
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
  const bool written = descriptor >= 0 && ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (descriptor >= 0) ::close(descriptor);
  if (!written) throw std::runtime_error(file + " cannot be written");
}

std::map<msg::Id, Outcome> read_record(const std::string& file) {
  std::map<msg::Id, Outcome> out;
  if (!std::filesystem::exists(file)) return out;
  std::ifstream in(file);
  for (std::string text; std::getline(in, text);) {
    std::istringstream line(text);
    std::string hex;
    Outcome outcome;
    if (!(line >> hex >> outcome.kind >> outcome.robot >> outcome.state >> outcome.code >> outcome.steps >> outcome.chain))
      throw std::runtime_error(file + ": not a line of a record: " + text);
    std::getline(line >> std::ws, outcome.reason);
    if (outcome.chain == "-") outcome.chain.clear();
    if (!out.emplace(msg::id_from_hex(hex).value(), outcome).second) throw std::runtime_error(file + ": twice: " + hex);
  }
  return out;
}

}  // namespace foothold::faults
