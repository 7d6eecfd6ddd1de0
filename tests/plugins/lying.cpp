// Reports what contradicts itself.
#include <limits>

#include "walker.hpp"

namespace {

using namespace foothold;

class Lying : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters& parameters, const PreparedScene&, PlanContext& context) override {
    if (!context.emit(step(0))) return stopped();
    PlanReport report = reached(1);
    const std::string& about = parameters.text("about");
    if (about == "optimal") report.lower_bound = 0.5;
    if (about == "bound") report.optimal = false, report.lower_bound = 2.0;
    if (about == "nan") report.cost = std::numeric_limits<double>::quiet_NaN();
    if (about == "stopped") report = stopped();
    if (about == "silent") report.outcome = PlanReport::Outcome::kFailed, report.optimal = false;
    if (about == "number") report.outcome = PlanReport::Outcome::kFailed, report.optimal = false, report.own_error = 899;
    return report;
  }
};

constexpr std::array kParameters = {ParameterSpec{"about", ParameterKind::kChoice, "", "optimal", 0, 0,
                                                  "optimal|bound|nan|stopped|silent|number", "What it lies about."}};

}  // namespace

FOOTHOLD_TEST_PLANNER(Lying, "lying", kParameters)
