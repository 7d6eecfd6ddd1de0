// config/robots/*.yaml, with the numbers of `model:` (foothold::load_robot_model).
#include <cmath>
#include <filesystem>

#include "../fuzzing.hpp"
#include "config/reading.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  const std::string file = fuzz::as_file("robot.yaml", fuzz::octets_of(data, size));
  server::ServerConfig config;
  config.robots_dir = std::filesystem::path(file).parent_path().string();
  config.plugin_dir = config.robots_dir;
  try {
    for (const server::RobotConfig& robot : server::read_robots(config)) {
      fuzz::demand(!robot.name.empty(), "a robot has a name");
      for (const auto& [name, quantity] : robot.model.quantities())
        for (const double value : quantity.values) fuzz::demand(std::isfinite(value), "a quantity is finite");
    }
  } catch (const server::ConfigError& error) {
    fuzz::demand(!error.faults().empty(), "a refusal says why");
  }
  return 0;
}
