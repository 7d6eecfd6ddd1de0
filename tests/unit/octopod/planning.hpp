// What tests of whole plans of the octopod share: parameters, scenes, requests, and a host that judges every step.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "octopod/planner.hpp"
#include "octopod/schema.hpp"
#include "robot.hpp"

namespace foothold::octopod {

inline RobotModel robot_file() { return load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/octopod.yaml"); }

// One for all tests that do not ask what a fresh planner does.
inline OctopodPlanner& shared_planner() {
  static OctopodPlanner planner(robot_file());
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

// A scene of config/scenes by its stem.
inline Scene shipped(const std::string& stem) { return {stem, "", "yaml", FOOTHOLD_CONFIG_DIR "/scenes/" + stem + ".yaml"}; }

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

// Collects steps, and stops the plan after some.
class Collector final : public PlanContext {
 public:
  explicit Collector(std::uint64_t seed = 0) { random.seed(seed); }
  bool emit(Step step) override {
    steps.push_back(std::move(step));
    return steps.size() < most;
  }
  std::vector<Step> steps;
  std::size_t most = 10000;
};

// Plans and judges every step as the host does.
inline PlanReport judged_plan(OctopodPlanner& planner, const Request& request, const Parameters& values, const PreparedScene& scene,
                              Collector& out) {
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

}  // namespace foothold::octopod
