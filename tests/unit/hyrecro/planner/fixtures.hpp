// What the tests of HyReCRo's planner share: the robot of the repository, scenes, requests, and a host that judges every step.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "foothold/robot_file.hpp"
#include "hyrecro/planner.hpp"
#include "hyrecro/schema.hpp"

namespace foothold::hyrecro {

inline RobotModel robot() { return load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml"); }

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

// A scene file that goes with the test.
class SceneFile {
 public:
  explicit SceneFile(const std::string& text)
      : path_(std::filesystem::path(testing::TempDir()) /
              (std::string("hyrecro_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml")) {
    std::ofstream(path_) << text;
  }
  ~SceneFile() { std::filesystem::remove(path_); }
  SceneFile(const SceneFile&) = delete;
  SceneFile& operator=(const SceneFile&) = delete;
  Scene scene() const { return {"test", "", "yaml", path_.string()}; }

 private:
  std::filesystem::path path_;
};

// A sole at `at` whose +Z is `up` and whose +X is `forward`; both axes of the world, perpendicular.
inline Isometry3d sole_at(const Vector3d& at, const Vector3d& up, const Vector3d& forward) {
  Isometry3d out = Isometry3d::Identity();
  out.linear() << forward, up.cross(forward), up;
  out.translation() = at;
  return out;
}

inline Contact contact(const char* limb, const Isometry3d& pose) { return {limb, pose, ""}; }

inline Request request_between(const Isometry3d& start, const Isometry3d& goal) {
  Request request;
  request.start.contacts = {contact("A", start)};
  request.goal.contacts = {contact("", goal)};
  request.budget = 10.0;
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
inline PlanReport judged_plan(HyrecroPlanner& planner, const Request& request, const Parameters& values, const PreparedScene& scene,
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

}  // namespace foothold::hyrecro
