// What tests of whole plans of Hex-piderix share: parameters, requests, and a host that judges every step.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "grounds.hpp"
#include "hexpiderix/planner.hpp"
#include "hexpiderix/schema.hpp"
#include "slopes.hpp"

namespace foothold::hexpiderix::testing {

inline HexpiderixPlanner& shared_planner() {
  static HexpiderixPlanner planner(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hexpiderix.yaml"));
  return planner;
}

// The defaults of the schema with some values set as text.
inline Parameters parameters(const std::map<std::string, std::string>& set = {}) {
  std::map<std::string, Parameters::Value, std::less<>> values;
  for (const ParameterSpec& spec : kParameters) {
    const auto given = set.find(spec.name);
    values.emplace(spec.name, parse_parameter(spec, given == set.end() ? spec.default_value : given->second.c_str()));
  }
  return Parameters(std::move(values));
}

inline Scene shipped(const std::string& stem) { return {stem, "", "yaml", FOOTHOLD_CONFIG_DIR "/scenes/" + stem + ".yaml"}; }

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

// Collects steps, and stops the plan after some.
class Collector final : public PlanContext {
 public:
  bool emit(Step step) override {
    steps.push_back(std::move(step));
    return steps.size() < most;
  }
  std::vector<Step> steps;
  std::size_t most = 10000;
};

// Plans and judges every step as the host does.
inline PlanReport judged_plan(HexpiderixPlanner& planner, const Request& request, const Parameters& values,
                              const PreparedScene& scene, Collector& out) {
  Posture before = planner.start(request, values, scene);
  const PlanReport report = planner.plan(request, values, scene, out);
  for (const Step& step : out.steps) {
    const StepVerdict verdict = planner.check(step, before, values, scene);
    EXPECT_TRUE(verdict.accepted) << step.label << ": " << verdict.reason;
    for (const Margin& margin : verdict.margins) EXPECT_GE(margin.value, margin.least) << step.label << ": " << margin.name;
    before = step.after;
  }
  return report;
}

}  // namespace foothold::hexpiderix::testing
