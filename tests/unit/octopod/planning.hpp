// What tests of whole plans of the octopod share: parameters, scenes, requests, and a host that judges every step.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "octopod/planner.hpp"
#include "octopod/schema.hpp"
#include "plans/plans.hpp"
#include "robot.hpp"

namespace foothold::octopod {

inline RobotModel robot_file() { return load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/octopod.yaml"); }

// One for all tests that do not ask what a fresh planner does.
inline OctopodPlanner& shared_planner() {
  static OctopodPlanner planner(robot_file());
  return planner;
}

using test::Collector;
using test::judged_plan;
using test::shipped;

// The defaults of the schema with some values set as text.
inline Parameters parameters(const std::map<std::string, std::string>& set = {}) { return test::parameters_of(kParameters, set); }

// The paper's points on its terrain.
inline const Vector3d kPaperStart(0.0, 0.0, -0.5), kPaperA(0.0, 0.75, -0.2), kPaperB(-1.0, -0.4, 0.2);

inline Placement place(const Vector3d& at) {
  Placement out;
  out.base = Isometry3d(Eigen::Translation3d(at));
  out.any_orientation = true;
  return out;
}

inline Request request_between(const Vector3d& start, const Vector3d& goal) {
  Request request;
  request.start = place(start);
  request.goal = place(goal);
  request.budget = 30.0;
  return request;
}

}  // namespace foothold::octopod
