// Emits without end, as fast as it can, until it is told to stop.
#include "walker.hpp"

namespace {

using namespace foothold;

class Flood : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters&, const PreparedScene&, PlanContext& context) override {
    for (int index = 0; context.emit(step(index)); ++index) {
    }
    return stopped();
  }
};

constexpr std::array<ParameterSpec, 0> kParameters = {};

}  // namespace

FOOTHOLD_TEST_PLANNER(Flood, "flood", kParameters)
