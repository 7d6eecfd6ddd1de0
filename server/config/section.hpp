// A map of a YAML file, read key by key against what is allowed there. Notes every fault and goes on, so that all are reported at
// once. For the sources of this folder only: it shows yaml-cpp.
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/faults.hpp"

namespace foothold::server {

struct Bounds {
  double least = 0.0;
  double most = std::numeric_limits<double>::max();
};

class Section {
 public:
  // `path`: of this map in the file, empty for the whole. A node that is not there is an empty map.
  Section(Faults& faults, std::string file, const YAML::Node& node, std::string path = {});

  // Each reads `key` into `out` and leaves `out` as it is if the key is missing or at fault.
  void text(const std::string& key, std::string& out, std::size_t most_octets = 256);
  void choice(const std::string& key, std::string& out, const std::vector<std::string>& choices);
  void flag(const std::string& key, bool& out);
  void number(const std::string& key, double& out, Bounds bounds);
  void count(const std::string& key, std::size_t& out, Bounds bounds);
  void seconds(const std::string& key, double& out, Bounds bounds);
  void octets(const std::string& key, std::uint64_t& out, Bounds bounds);
  // Relative paths are relative to the file's folder; `out` is absolute.
  enum class Kind { kAny, kFile, kFolder };
  void path(const std::string& key, std::string& out, Kind kind = Kind::kAny);
  void paths(const std::string& key, std::vector<std::string>& out, Kind kind);
  Section section(const std::string& key);
  // `key` is read by somebody else.
  YAML::Node leave(const std::string& key);

  void require(const std::string& key);
  bool has(const std::string& key) const;
  void fault(const std::string& key, const std::string& reason);
  // After all keys: refuses the unknown ones, with the nearest known name, and those that are there twice.
  void end();

 private:
  YAML::Node find(const std::string& key);
  void fault_at(const YAML::Node& node, const std::string& field, const std::string& reason);
  std::string field(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  bool scalar(const YAML::Node& node, const std::string& field, const char* wanted);
  void quantity(const std::string& key, Bounds bounds, const char* wanted, const char* unit, bool whole,
                const std::function<std::optional<double>(std::string_view)>& parse, const std::function<void(double)>& set);
  std::optional<std::string> absolute(const YAML::Node& node, const std::string& field, Kind kind);

  Faults& faults_;
  std::string file_;
  YAML::Node node_;
  std::vector<std::pair<std::string, YAML::Node>> entries_;  // those with words for keys, in order
  bool broken_ = false;                                      // it is there, but no map
  std::string path_;
  std::vector<std::string> known_;
};

// The file as a tree; nothing, and a fault, if it cannot be read or is not YAML.
std::optional<YAML::Node> load_yaml(const std::string& file, Faults& faults);

}  // namespace foothold::server
