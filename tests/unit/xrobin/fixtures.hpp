// What the tests of Xrobin share: the robot of the repository and a context that collects steps.
#pragma once

#include <string>
#include <vector>

#include "foothold/planner.hpp"
#include "foothold/robot_file.hpp"
#include "mechanism.hpp"
#include "plans/plans.hpp"
#include "schema.hpp"

namespace foothold::xrobin {

inline RobotModel robot() { return load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/xrobin.yaml"); }

inline Mechanism mechanism() { return Mechanism::from_model(robot()); }

using test::Collector;

// The defaults of the schema with some values set as text.
inline Parameters parameters(const std::map<std::string, std::string>& set = {}) { return test::parameters_of(kParameters, set); }

inline Request request_to(double x, double y) {
  Request request;
  request.goal.base = Isometry3d(Eigen::Translation3d(x, y, 0.0));
  request.goal.any_orientation = true;
  request.budget = 10.0;
  return request;
}

}  // namespace foothold::xrobin
