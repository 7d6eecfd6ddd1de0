// Emits as many steps as it is told, at once or with a pause or work before each: for throughput, latency and everyday use in
// tests.
#include "walker.hpp"

namespace {

using namespace foothold;

class Many : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters& parameters, const PreparedScene&, PlanContext& context) override {
    const auto steps = static_cast<int>(parameters.integer("steps"));
    const double pause_s = 1e-6 * static_cast<double>(parameters.integer("pause_us"));
    const std::chrono::microseconds work(parameters.integer("work_us"));
    for (int index = 0; index < steps; ++index) {
      if (pause_s > 0.0) pause(context, pause_s);
      const auto end = std::chrono::steady_clock::now() + work;
      while (std::chrono::steady_clock::now() < end) {
      }
      if (context.stop.stop_requested() || !context.emit(step(index))) return stopped();
    }
    return reached(steps);
  }
};

constexpr std::array kParameters = {
    ParameterSpec{"steps", ParameterKind::kInteger, "1", "10", 0, 1e6, "", "How many steps the plan has."},
    ParameterSpec{"pause_us", ParameterKind::kInteger, "us", "0", 0, 1e6, "", "Idle time before each step."},
    ParameterSpec{"work_us", ParameterKind::kInteger, "us", "0", 0, 1e6, "", "Busy time before each step."}};

}  // namespace

FOOTHOLD_TEST_PLANNER(Many, "many", kParameters)
