// What tests of whole plans share, whichever the robot: parameters from its schema, shipped scenes, and a host that collects steps
// and judges each of them.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <span>
#include <string>
#include <vector>

#include "foothold/planner.hpp"

namespace foothold::test {

// The defaults of a schema with some values set as text.
inline Parameters parameters_of(std::span<const ParameterSpec> schema, const std::map<std::string, std::string>& set) {
  std::map<std::string, Parameters::Value, std::less<>> values;
  for (const ParameterSpec& spec : schema) {
    const auto given = set.find(spec.name);
    values.emplace(spec.name, parse_parameter(spec, given == set.end() ? spec.default_value : given->second.c_str()));
  }
  return Parameters(std::move(values));
}

// A scene of config/scenes by its stem.
inline Scene shipped(const std::string& stem) { return {stem, "", "yaml", FOOTHOLD_CONFIG_DIR "/scenes/" + stem + ".yaml"}; }

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
inline PlanReport judged_plan(Planner& planner, const Request& request, const Parameters& values, const PreparedScene& scene,
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

}  // namespace foothold::test
