// Searches for ever, and looks at its stop token every millisecond.
#include "walker.hpp"

namespace {

using namespace foothold;

class Heed : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters&, const PreparedScene&, PlanContext& context) override {
    context.emit(step(0));
    while (!context.stop.stop_requested()) pause(context, 1.0);
    return stopped();
  }
};

constexpr std::array<ParameterSpec, 0> kParameters = {};

}  // namespace

FOOTHOLD_TEST_PLANNER(Heed, "heed", kParameters)
