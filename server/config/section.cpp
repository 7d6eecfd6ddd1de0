// Reading a map of a YAML file.
#include "config/section.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "config/words.hpp"

namespace foothold::server {
namespace fs = std::filesystem;

namespace {

std::string shown(const YAML::Node& node) {
  if (node.IsMap()) return "is a map";
  if (node.IsSequence()) return "is a list";
  if (node.IsNull()) return "is empty";
  return "is '" + node.Scalar() + "'";
}

std::string shown(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const auto& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

}  // namespace

Section::Section(Faults& faults, std::string file, const YAML::Node& node, std::string path)
    : faults_(faults), file_(std::move(file)), path_(std::move(path)) {
  if (!node.IsDefined() || node.IsNull()) return;
  broken_ = !node.IsMap();
  if (broken_) {
    fault_at(node, path_, "must be a map (" + shown(node) + ")");
    return;
  }
  node_.reset(node);
  // Once: each look at a map of yaml-cpp's makes its entries anew.
  for (const auto& entry : node_)
    if (entry.first.IsScalar()) entries_.emplace_back(entry.first.Scalar(), entry.second);
}

void Section::fault_at(const YAML::Node& node, const std::string& field, const std::string& reason) {
  faults_.add(file_, node.Mark().line + 1, field, reason);
}

void Section::fault(const std::string& key, const std::string& reason) {
  const YAML::Node node = find(key);
  fault_at(node.IsDefined() ? node : node_, field(key), reason);
}

YAML::Node Section::find(const std::string& key) {
  if (std::ranges::find(known_, key) == known_.end()) known_.push_back(key);
  const auto found = std::ranges::find(entries_, key, &std::pair<std::string, YAML::Node>::first);
  return found == entries_.end() ? YAML::Node(YAML::NodeType::Undefined) : found->second;
}

bool Section::has(const std::string& key) const {
  return std::ranges::find(entries_, key, &std::pair<std::string, YAML::Node>::first) != entries_.end();
}

void Section::require(const std::string& key) {
  if (!broken_ && !has(key)) faults_.add(file_, node_.IsMap() ? node_.Mark().line + 1 : 1, field(key), "is missing");
}

YAML::Node Section::leave(const std::string& key) { return find(key); }

bool Section::scalar(const YAML::Node& node, const std::string& field, const char* wanted) {
  if (!node.IsDefined()) return false;
  if (node.IsScalar()) return true;
  fault_at(node, field, std::string("must be ") + wanted + " (" + shown(node) + ")");
  return false;
}

void Section::text(const std::string& key, std::string& out, std::size_t most_octets) {
  const YAML::Node node = find(key);
  if (!scalar(node, field(key), "text")) return;
  if (node.Scalar().empty())
    fault_at(node, field(key), "must not be empty");
  else if (node.Scalar().size() > most_octets)
    fault_at(node, field(key),
             "must have " + std::to_string(most_octets) + " octets at most (has " + std::to_string(node.Scalar().size()) + ")");
  else
    out = node.Scalar();
}

void Section::choice(const std::string& key, std::string& out, const std::vector<std::string>& choices) {
  const YAML::Node node = find(key);
  if (!scalar(node, field(key), "a word")) return;
  if (std::ranges::find(choices, node.Scalar()) != choices.end())
    out = node.Scalar();
  else
    fault_at(node, field(key), "must be one of " + joined(choices) + " (" + shown(node) + ")");
}

void Section::flag(const std::string& key, bool& out) {
  const YAML::Node node = find(key);
  if (!scalar(node, field(key), "true or false")) return;
  if (node.Scalar() == "true" || node.Scalar() == "false")
    out = node.Scalar() == "true";
  else
    fault_at(node, field(key), "must be true or false (" + shown(node) + ")");
}

void Section::quantity(const std::string& key, Bounds bounds, const char* wanted, const char* unit, bool whole,
                       const std::function<std::optional<double>(std::string_view)>& parse,
                       const std::function<void(double)>& set) {
  const YAML::Node node = find(key);
  if (!scalar(node, field(key), wanted)) return;
  const auto value = parse(node.Scalar());
  if (!value || (whole && *value != std::floor(*value)))
    fault_at(node, field(key), std::string("must be ") + wanted + " (" + shown(node) + ")");
  else if (*value < bounds.least || *value > bounds.most)
    fault_at(node, field(key), "must be " + shown(bounds.least) + " to " + shown(bounds.most) + unit + " (" + shown(node) + ")");
  else
    set(*value);
}

void Section::number(const std::string& key, double& out, Bounds bounds) {
  quantity(key, bounds, "a number", "", false, parse_number, [&](double value) { out = value; });
}

void Section::count(const std::string& key, std::size_t& out, Bounds bounds) {
  quantity(key, bounds, "a whole number", "", true, parse_number, [&](double value) { out = static_cast<std::size_t>(value); });
}

void Section::seconds(const std::string& key, double& out, Bounds bounds) {
  quantity(key, bounds, "a time, in seconds or with ms, s, min, h or d", " s", false, parse_seconds,
           [&](double value) { out = value; });
}

void Section::octets(const std::string& key, std::uint64_t& out, Bounds bounds) {
  quantity(key, bounds, "a size, in octets or with kB, MB, GB, KiB, MiB or GiB", " octets", true, parse_octets,
           [&](double value) { out = static_cast<std::uint64_t>(value); });
}

std::optional<std::string> Section::absolute(const YAML::Node& node, const std::string& field, Kind kind) {
  if (!scalar(node, field, "a path")) return std::nullopt;
  if (node.Scalar().empty()) {
    fault_at(node, field, "must not be empty");
    return std::nullopt;
  }
  const fs::path path = (fs::absolute(file_).parent_path() / node.Scalar()).lexically_normal();
  std::error_code ignored;
  if (kind == Kind::kFile && !fs::is_regular_file(path, ignored))
    fault_at(node, field, "must be a file that is there (is '" + path.string() + "')");
  else if (kind == Kind::kFolder && !fs::is_directory(path, ignored))
    fault_at(node, field, "must be a folder that is there (is '" + path.string() + "')");
  else
    return path.string();
  return std::nullopt;
}

void Section::path(const std::string& key, std::string& out, Kind kind) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (auto path = absolute(node, field(key), kind)) out = std::move(*path);
}

void Section::paths(const std::string& key, std::vector<std::string>& out, Kind kind) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsSequence()) return fault_at(node, field(key), "must be a list of paths (" + shown(node) + ")");
  out.clear();
  for (std::size_t i = 0; i < node.size(); ++i)
    if (auto path = absolute(node[i], field(key) + "[" + std::to_string(i) + "]", kind)) out.push_back(std::move(*path));
}

Section Section::section(const std::string& key) { return Section(faults_, file_, find(key), field(key)); }

void Section::end() {
  if (!node_.IsMap()) return;
  std::map<std::string, int> times;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) {
      fault_at(entry.first, path_, "has a key that is not a word");
      continue;
    }
    const std::string& key = entry.first.Scalar();
    if (++times[key] == 2) fault_at(entry.first, field(key), "is given twice");
    if (std::ranges::find(known_, key) != known_.end()) continue;
    const std::string meant = nearest(key, known_);
    fault_at(entry.first, field(key),
             "is not known here" + (meant.empty() ? "; known are " + joined(known_) : "; is '" + meant + "' meant?"));
  }
}

std::optional<YAML::Node> load_yaml(const std::string& file, Faults& faults) {
  try {
    return YAML::LoadFile(file);
  } catch (const YAML::BadFile&) {
    faults.add(file, 0, "", "cannot be read");
  } catch (const YAML::Exception& error) {
    faults.add(file, error.mark.line + 1, "", "is not YAML: " + error.msg);
  }
  return std::nullopt;
}

}  // namespace foothold::server
