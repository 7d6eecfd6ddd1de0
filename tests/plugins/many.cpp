// Emits as many steps as it is told, at once or with work or pauses in between: for throughput, latency and everyday use in tests.
#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

#include "walker.hpp"

namespace {

using namespace foothold;

class Many : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters& parameters, const PreparedScene&, PlanContext& context) override {
    const auto steps = static_cast<int>(parameters.integer("steps"));
    const std::chrono::microseconds work(parameters.integer("work_us")), pause(parameters.integer("pause_us"));
    for (int index = 0; index < steps; ++index) {
      const auto end = std::chrono::steady_clock::now() + work;
      while (std::chrono::steady_clock::now() < end) {
      }
      rest(pause, context.stop);
      if (context.stop.stop_requested() || !context.emit(step(index))) return stopped();
    }
    return reached(steps);
  }

 private:
  // Not longer than a planner may go without a look at its stop token.
  static void rest(std::chrono::microseconds left, const std::stop_token& stop) {
    for (; left.count() > 0 && !stop.stop_requested(); left -= kSlice) std::this_thread::sleep_for(std::min(left, kSlice));
  }
  static constexpr std::chrono::microseconds kSlice{2000};
};

constexpr std::array kParameters = {
    ParameterSpec{"steps", ParameterKind::kInteger, "1", "10", 0, 1e6, "", "How many steps the plan has."},
    ParameterSpec{"work_us", ParameterKind::kInteger, "us", "0", 0, 1e6, "", "Busy time before each step."},
    ParameterSpec{"pause_us", ParameterKind::kInteger, "us", "0", 0, 1e6, "", "Idle time before each step."}};

}  // namespace

FOOTHOLD_EXPORT_PLANNER(Many, (foothold::PlannerInfo{.name = "many",
                                                     .version = "1.0.0",
                                                     .description = "as many steps as it is told",
                                                     .limbs = "left|right",
                                                     .parameters = kParameters.data(),
                                                     .parameter_count = kParameters.size()}))
