// robots/*.yaml: what the server needs of a robot; its numbers (`model:`) are read by foothold::robot_file.
#include "foothold/robot_file.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "config/reading.hpp"
#include "config/section.hpp"

namespace foothold::server {
namespace fs = std::filesystem;

namespace {

// `plugin:` is a name in the plugins' folder, or a path that is relative to the robot's file.
std::string plugin_path(const std::string& plugin, const std::string& file, const std::string& plugin_dir) {
  if (plugin.find('/') != std::string::npos) return (fs::absolute(file).parent_path() / plugin).lexically_normal().string();
  const bool bare = plugin.find('.') == std::string::npos;
  return (fs::path(plugin_dir) / (bare ? plugin + ".so" : plugin)).string();
}

RobotConfig read_robot(const std::string& file, const std::string& plugin_dir, Faults& faults) {
  RobotConfig robot;
  robot.file = file;
  const auto tree = load_yaml(file, faults);
  if (!tree) return robot;
  Section root(faults, file, *tree);
  root.require("robot");
  root.text("robot", robot.name, 64);
  root.text("description", robot.description, 1024);
  root.require("plugin");
  root.text("plugin", robot.plugin, 1024);
  robot.plugin = plugin_path(robot.plugin, file, plugin_dir);
  root.count("slots", robot.slots, {1, 256});
  root.octets("memory_limit", robot.memory_limit, {1024.0 * 1024.0, 1e15});
  root.flag("enabled", robot.enabled);
  const bool has_model = root.leave("model").IsDefined();
  root.end();
  if (!has_model) return robot;
  try {
    robot.model = load_robot_model(file);
  } catch (const FileError& error) {
    faults.add(error.what());
  }
  return robot;
}

}  // namespace

std::vector<RobotConfig> read_robots(const ServerConfig& config) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator entry(config.robots_dir, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".yaml") files.push_back(entry->path().string());
  std::ranges::sort(files);

  Faults faults;
  if (error) faults.add(config.robots_dir, 0, "", "cannot be read: " + error.message());
  if (!error && files.empty()) faults.add(config.robots_dir, 0, "", "holds no robot's file (*.yaml)");
  std::vector<RobotConfig> robots;
  std::map<std::string, std::string> files_of;
  for (const auto& file : files) {
    robots.push_back(read_robot(file, config.plugin_dir, faults));
    const auto [known, is_new] = files_of.emplace(robots.back().name, file);
    if (!is_new && !robots.back().name.empty())
      faults.add(file, 0, "robot", "'" + robots.back().name + "' is the name of the robot in " + known->second + " already");
  }
  if (!faults.empty()) throw ConfigError(faults);
  return robots;
}

}  // namespace foothold::server
