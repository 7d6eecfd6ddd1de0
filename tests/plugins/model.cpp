// A planner whose constructor does what its robot's model says: throws, hangs, dies, or reads a number.
#include <cstdlib>
#include <stdexcept>

#include "walker.hpp"

namespace {

using namespace foothold;

class Model : public test::Walker {
 public:
  explicit Model(const RobotModel& model) : Walker(model) {
    if (model.has("throws")) throw std::runtime_error("the constructor's words");
    if (model.has("throws_int")) throw 42;
    if (model.has("dies")) std::abort();
    if (model.has("hangs"))
      for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
    (void)model.number("body.length", "m");
  }
  PlanReport plan(const Request&, const Parameters&, const PreparedScene&, PlanContext& context) override {
    context.emit(step(0));
    return reached(1);
  }
};

constexpr std::array<ParameterSpec, 0> kParameters = {};

}  // namespace

FOOTHOLD_TEST_PLANNER(Model, "model", kParameters)
