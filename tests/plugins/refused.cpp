// Emits a step that its own check() refuses, or one that no message may hold; then goes on as if nothing had happened.
#include <limits>

#include "walker.hpp"

namespace {

using namespace foothold;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class Refused : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters& parameters, const PreparedScene&, PlanContext& context) override {
    const auto at = static_cast<int>(parameters.integer("at"));
    const std::string& how = parameters.text("how");
    for (int index = 0; index < at + 3; ++index) {
      Step next = step(index);
      if (index == at) {
        if (how == "too_far") next.after.base.translation().x() += 0.5;
        if (how == "nan_joint") next.after.joints = {0.0, kNan};
        if (how == "no_rotation") next.after.stance[1].frame.linear() *= 1.1;
        if (how == "nan_cost") next.cost = kNan;
        if (how == "margin") next.label = "low";
        if (how == "label") next.label = std::string("a\0b", 3);
        if (how == "huge") next.label = std::string(17u << 20, 'x');
      }
      context.emit(std::move(next));
    }
    return reached(at + 3);
  }
  StepVerdict check(const Step& step, const Posture& before, const Parameters& parameters,
                    const PreparedScene& scene) const override {
    StepVerdict verdict = Walker::check(step, before, parameters, scene);
    if (step.label == "low") verdict.margins = {{"balance", 0.01, 0.02, "m"}};
    return verdict;
  }
};

constexpr std::array kParameters = {
    ParameterSpec{"at", ParameterKind::kInteger, "1", "4", 0, 1000, "", "Which step is bad."},
    ParameterSpec{"how", ParameterKind::kChoice, "", "too_far", 0, 0, "too_far|nan_joint|no_rotation|nan_cost|margin|label|huge",
                  "What is bad about it."}};

}  // namespace

FOOTHOLD_TEST_PLANNER(Refused, "refused", kParameters)
