// Dies in mid-plan, at the step and in the way that it is told.
#include <csignal>
#include <cstdlib>

#include "walker.hpp"

namespace {

using namespace foothold;

void die(const std::string& how) {
  if (how == "abort") std::abort();
  if (how == "exit") std::exit(7);
  if (how == "kill") std::raise(SIGKILL);
  *static_cast<volatile int*>(nullptr) = 1;
}

class Crash : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters& parameters, const PreparedScene&, PlanContext& context) override {
    const auto at = static_cast<int>(parameters.integer("at"));
    for (int index = 0; index < at; ++index)
      if (!context.emit(step(index))) return stopped();
    if (parameters.text("how") != "not") die(parameters.text("how"));
    return reached(at);
  }
};

constexpr std::array kParameters = {
    ParameterSpec{"at", ParameterKind::kInteger, "1", "3", 0, 1000, "", "How many steps go before the crash."},
    ParameterSpec{"how", ParameterKind::kChoice, "", "segv", 0, 0, "segv|abort|exit|kill|not", "What it dies of."}};

}  // namespace

FOOTHOLD_TEST_PLANNER(Crash, "crash", kParameters)
