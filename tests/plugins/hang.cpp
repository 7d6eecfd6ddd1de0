// Sleeps for ever in the function that it is told, whatever its stop token says.
#include "walker.hpp"

namespace {

using namespace foothold;

[[noreturn]] void hang() {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

class Hang : public test::Walker {
 public:
  using Walker::Walker;

  std::shared_ptr<const PreparedScene> prepare(const Scene& scene, const Parameters& parameters) override {
    if (parameters.text("in") == "prepare") hang();
    return Walker::prepare(scene, parameters);
  }
  PlanReport plan(const Request&, const Parameters&, const PreparedScene&, PlanContext& context) override {
    context.emit(step(0));
    hang();
  }
};

constexpr std::array kParameters = {
    ParameterSpec{"in", ParameterKind::kChoice, "", "plan", 0, 0, "plan|prepare", "Where it hangs."}};

}  // namespace

FOOTHOLD_TEST_PLANNER(Hang, "hang", kParameters)
