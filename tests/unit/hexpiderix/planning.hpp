// What tests of whole plans of Hex-piderix share: parameters, requests, and a host that judges every step.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grounds.hpp"
#include "hexpiderix/planner.hpp"
#include "hexpiderix/schema.hpp"
#include "plans/plans.hpp"
#include "slopes.hpp"

namespace foothold::hexpiderix::testing {

inline HexpiderixPlanner& shared_planner() {
  static HexpiderixPlanner planner(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hexpiderix.yaml"));
  return planner;
}

using test::Collector;
using test::judged_plan;
using test::shipped;

// The defaults of the schema with some values set as text.
inline Parameters parameters(const std::map<std::string, std::string>& set = {}) { return test::parameters_of(kParameters, set); }

inline Isometry3d pose(const Vector3d& at, double heading = 0.0) {
  return Eigen::Translation3d(at) * Isometry3d(Eigen::AngleAxisd(heading, Vector3d::UnitZ()));
}

// To adapt at a place; with a goal, to walk there.
inline Request request_at(const Vector3d& place, double heading = 0.0) {
  Request request;
  request.start.base = pose(place, heading);
  request.budget = 30.0;
  return request;
}
inline Request walk_between(const Vector3d& from, const Vector3d& to) {
  Request request = request_at(from);
  request.goal.base = pose(to);
  request.goal.any_orientation = true;
  return request;
}

}  // namespace foothold::hexpiderix::testing
