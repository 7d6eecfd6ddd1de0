// What the test planners share: a body that walks along world +X in steps of 0.1 m, on nothing.
#pragma once

#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>

#include "foothold/export.hpp"

namespace foothold::test {

// Implements all but plan(). A step is accepted if it leads 0.1 m on.
class Walker : public Planner {
 public:
  explicit Walker(const RobotModel&) {}

  std::shared_ptr<const PreparedScene> prepare(const Scene&, const Parameters&) override {
    return std::make_shared<const PreparedScene>();
  }
  Posture start(const Request& request, const Parameters&, const PreparedScene&) const override {
    Posture posture;
    if (request.start.base) posture.base = *request.start.base;
    return posture;
  }
  StepVerdict check(const Step& step, const Posture& before, const Parameters&, const PreparedScene&) const override {
    const double advance = step.after.base.translation().x() - before.base.translation().x();
    if (std::abs(advance - 0.1) > 1e-9)
      return {.accepted = false, .reason = "the body moves " + std::to_string(advance) + " m, not 0.1 m"};
    return {.accepted = true, .margins = {{"advance", advance, 0.0, "m"}}};
  }
  std::vector<Shape> shapes(const Posture& posture) const override {
    return {{.kind = Shape::Kind::kBox, .body = "body", .pose = posture.base, .size = {0.1, 0.1, 0.1}}};
  }

 protected:
  // Step number `index` of the walk, from 0.
  static Step step(int index) {
    Step step;
    step.label = "step " + std::to_string(index);
    step.after.base.translation().x() = 0.1 * (index + 1);
    step.after.stance = {{"left", step.after.base, ""}, {"right", step.after.base, ""}};
    step.placed = {step.after.stance[static_cast<std::size_t>(index % 2)]};
    step.cost = index + 1;
    return step;
  }
  static PlanReport reached(int steps) {
    PlanReport report;
    report.outcome = PlanReport::Outcome::kReached;
    report.cost = report.lower_bound = steps;
    report.optimal = true;
    report.cost_unit = "1";
    report.objective = "number of steps";
    return report;
  }
  // Sleeps for `seconds` unless it is told to stop; looks every millisecond.
  static void pause(const PlanContext& context, double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    while (Clock::now() < end && !context.stop.stop_requested())
      std::this_thread::sleep_for(std::min<Clock::duration>(end - Clock::now(), std::chrono::milliseconds(1)));
  }
  static PlanReport stopped() {
    PlanReport report;
    report.outcome = PlanReport::Outcome::kStopped;
    return report;
  }
};

}  // namespace foothold::test

// `parameters`: a constexpr std::array of ParameterSpec.
#define FOOTHOLD_TEST_PLANNER(PlannerClass, planner_name, parameter_list)                           \
  FOOTHOLD_EXPORT_PLANNER(PlannerClass, (foothold::PlannerInfo{.name = planner_name,                \
                                                               .version = "1.0.0",                  \
                                                               .description = "a test planner",     \
                                                               .limbs = "left|right",               \
                                                               .parameters = parameter_list.data(), \
                                                               .parameter_count = parameter_list.size()}))
