// config/robots/<name>.yaml to a RobotModel in SI units.
#include "foothold/robot_file.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <set>
#include <string_view>

namespace foothold {
namespace {

struct Unit {
  const char* name;
  const char* si;
  double factor;
};

// Far beyond any robot: aliases may make a small file endless.
constexpr int kDeepest = 16;
constexpr std::size_t kMostEntries = 50000;
constexpr std::size_t kMostQuantities = 10000;

constexpr std::uintmax_t kLongestText = 4 << 20;  // octets
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr Unit kUnits[] = {{"m", "m", 1.0},     {"cm", "m", 0.01},       {"mm", "m", 0.001},
                           {"rad", "rad", 1.0}, {"deg", "rad", kDegree}, {"kg", "kg", 1.0},
                           {"g", "kg", 0.001},  {"s", "s", 1.0},         {"ms", "s", 0.001},
                           {"N", "N", 1.0},     {"Nm", "Nm", 1.0},       {"1", "1", 1.0},
                           {"m/s", "m/s", 1.0}, {"rad/s", "rad/s", 1.0}, {"rpm", "rad/s", 2.0 * std::numbers::pi / 60.0}};

// Of a string that may end here: then it is '\0'.
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Walks `model:` and collects its leaves; every fault names file, line and path.
class ModelReader {
 public:
  explicit ModelReader(const std::string& file) : file_(file) {}

  RobotModel read(const YAML::Node& model) {
    walk(model, "", 0);
    return RobotModel(std::move(quantities_), std::move(texts_));
  }

 private:
  [[noreturn]] void fail(const YAML::Node& node, const std::string& path, const std::string& reason) const {
    throw FileError(file_, node.Mark().line + 1, path.empty() ? "model" : "model." + path, reason);
  }

  void count(const YAML::Node& node, const std::string& path) {
    if (++entries_ > kMostEntries)
      fail(node, path, "there are more than " + std::to_string(kMostEntries) + " entries and numbers, aliases counted");
  }

  void walk(const YAML::Node& node, const std::string& path, int depth) {
    if (depth > kDeepest) fail(node, path, "is nested deeper than " + std::to_string(kDeepest) + " levels");
    count(node, path);
    if (path == "urdf") {
      if (!texts_.emplace(path, named_file(node, path)).second) fail(node, path, "is given twice");
      return;
    }
    if (!node.IsMap()) fail(node, path, "must be a map of quantities, or {value: ..., unit: ..., source: ...}");
    if (node["value"]) {
      if (!quantities_.emplace(path, leaf(node, path)).second) fail(node, path, "is given twice");
      if (quantities_.size() > kMostQuantities)
        fail(node, path, "there are more than " + std::to_string(kMostQuantities) + " quantities");
      return;
    }
    for (const auto& entry : node) {
      const auto key = entry.first.as<std::string>();
      walk(entry.second, path.empty() ? key : path + "." + key, depth + 1);
    }
  }

  std::string named_file(const YAML::Node& node, const std::string& path) const {
    namespace fs = std::filesystem;
    if (!node.IsScalar() || node.Scalar().empty()) fail(node, path, "must be the name of a file");
    const fs::path file = fs::path(file_).parent_path() / node.Scalar();
    std::error_code error;
    // What is no plain file may never end.
    if (!fs::is_regular_file(file, error)) fail(node, path, "is no file: " + file.string());
    if (fs::file_size(file, error) > kLongestText || error) fail(node, path, "must be a file of at most 4 MiB: " + file.string());
    std::ifstream in(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in || text.empty()) fail(node, path, "cannot be read or is empty: " + file.string());
    return text;
  }

  Quantity leaf(const YAML::Node& node, const std::string& path) {
    std::set<std::string> seen;
    for (const auto& entry : node) {
      const auto key = entry.first.as<std::string>();
      if (!seen.insert(key).second) fail(entry.first, path + "." + key, "is given twice");
      if (key != "value" && key != "unit" && key != "source" && key != "note")
        fail(entry.first, path + "." + key, "is not a part of a quantity (value, unit, source, note)");
    }
    const Unit& unit = unit_of(node, path);
    Quantity quantity{.values = {}, .unit = unit.si, .source = source_of(node, path)};
    const YAML::Node value = node["value"];
    if (value.IsSequence()) {
      for (const auto& element : value) {
        count(element, path);
        quantity.values.push_back(unit.factor * number(element, path));
      }
      if (quantity.values.empty()) fail(value, path + ".value", "must hold one number at least");
    } else {
      quantity.values.push_back(unit.factor * number(value, path));
    }
    return quantity;
  }

  double number(const YAML::Node& node, const std::string& path) const {
    double value = 0.0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value))
      fail(node, path + ".value", "must be a number" + (node.IsScalar() ? ", is '" + node.Scalar() + "'" : std::string()));
    if (!std::isfinite(value)) fail(node, path + ".value", "must be finite, is " + node.Scalar());
    return value;
  }

  const Unit& unit_of(const YAML::Node& node, const std::string& path) const {
    if (!node["unit"]) fail(node, path + ".unit", "is missing");
    const auto name = node["unit"].as<std::string>("");
    for (const Unit& unit : kUnits)
      if (name == unit.name) return unit;
    std::string known;
    for (const Unit& unit : kUnits) known += std::string(known.empty() ? "" : ", ") + unit.name;
    fail(node["unit"], path + ".unit", "must be one of " + known + "; is '" + name + "'");
  }

  // A number without a source is a guess: where it comes from is a part of it.
  std::string source_of(const YAML::Node& node, const std::string& path) const {
    if (!node["source"]) fail(node, path + ".source", "is missing (paper, public, derived or assumed, then why)");
    const auto source = node["source"].as<std::string>("");
    for (const char* tag : {"paper", "public", "derived", "assumed"})
      if (source.starts_with(tag) && !is_letter(source[std::string_view(tag).size()])) return source;
    fail(node["source"], path + ".source", "must begin with paper, public, derived or assumed; is '" + source + "'");
  }

  const std::string& file_;
  std::size_t entries_ = 0;
  std::map<std::string, Quantity, std::less<>> quantities_;
  std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace

FileError::FileError(const std::string& file, int line, const std::string& field, const std::string& reason)
    : std::runtime_error(file + ":" + std::to_string(line) + ": " + (field.empty() ? "" : field + ": ") + reason), field_(field) {}

RobotModel load_robot_model(const std::string& path) {
  try {
    const YAML::Node root = YAML::LoadFile(path);
    if (!root.IsMap()) throw FileError(path, 1, "", "must be a map with the keys robot, plugin, model");
    if (!root["model"]) throw FileError(path, root.Mark().line + 1, "model", "is missing");
    return ModelReader(path).read(root["model"]);
  } catch (const YAML::BadFile&) {
    throw FileError(path, 0, "", "cannot be read");
  } catch (const YAML::Exception& fault) {
    throw FileError(path, fault.mark.line + 1, "", fault.msg);
  }
}

}  // namespace foothold
