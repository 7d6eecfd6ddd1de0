// Reads the model part of config/robots/<name>.yaml. Library foothold::robot_file; planners do not need it, hosts and tests do.
//
//   model:
//     piston:
//       retracted: {value: 103, unit: mm, source: "derived: ..."}
//       limits:    {value: [-90, 90], unit: deg, source: assumed}
//     urdf: robot.urdf
//
// `urdf` names a file of at most 4 MiB, relative to the robot's: its text travels with the model, for planners that read it.
// Units mm, cm, m, deg, rad, g, kg, s, ms, N, Nm, m/s, rpm, rad/s, 1 are converted to SI (m, rad, kg, s, N, Nm, m/s, rad/s, 1).
#pragma once

#include <stdexcept>
#include <string>

#include "foothold/model.hpp"

namespace foothold {

// what() is "file:line: field: reason".
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& file, int line, const std::string& field, const std::string& reason);
  const std::string& field() const noexcept { return field_; }

 private:
  std::string field_;
};

// Throws FileError. Any thread.
RobotModel load_robot_model(const std::string& path);

}  // namespace foothold
