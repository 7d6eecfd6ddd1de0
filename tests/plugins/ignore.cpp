// Works for ever and never looks at its stop token.
#include <atomic>

#include "walker.hpp"

namespace {

using namespace foothold;

class Ignore : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters&, const PreparedScene&, PlanContext& context) override {
    context.emit(step(0));
    for (std::atomic<unsigned> work = 0;;) work.fetch_add(1, std::memory_order_relaxed);
  }
};

constexpr std::array<ParameterSpec, 0> kParameters = {};

}  // namespace

FOOTHOLD_TEST_PLANNER(Ignore, "ignore", kParameters)
