// A planner of Bioloid and requests for it: what tests of whole plans share.
#pragma once

#include "bioloid/planner.hpp"
#include "bioloid/schema.hpp"
#include "plans/plans.hpp"
#include "robot.hpp"

namespace foothold::bioloid::testing {

using test::Collector;
using test::judged_plan;
using Set = std::map<std::string, std::string>;

inline Parameters parameters(const Set& set = {}) { return test::parameters_of(kParameters, set); }

inline BioloidPlanner& shared_planner() {
  static BioloidPlanner planner(load_robot_model(kRobotFile));
  return planner;
}

inline Isometry3d on_floor(double x, double y, double heading) { return geometry::to_world({x, y, heading}); }

inline Request walk_request(const Isometry3d& from, const Isometry3d& to) {
  Request request;
  request.start.base = from;
  request.goal.base = to;
  request.budget = 30.0;
  return request;
}

}  // namespace foothold::bioloid::testing
