// Throws what it is told, where it is told.
#include <new>
#include <stdexcept>

#include "walker.hpp"

namespace {

using namespace foothold;

void maybe_throw(const Parameters& parameters, const char* where) {
  if (parameters.text("in") != where) return;
  const std::string& what = parameters.text("what");
  if (what == "int") throw 42;
  if (what == "bad_alloc") throw std::bad_alloc();
  if (what == "request") throw InvalidRequest(parameters.text("field"), "cannot be planned for");
  if (what == "scene") throw InvalidScene("beams[2].length", "must be above 0, is -1");
  throw std::runtime_error("the thrown words");
}

class Throw : public test::Walker {
 public:
  using Walker::Walker;

  std::shared_ptr<const PreparedScene> prepare(const Scene& scene, const Parameters& parameters) override {
    maybe_throw(parameters, "prepare");
    return Walker::prepare(scene, parameters);
  }
  Posture start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const override {
    maybe_throw(parameters, "start");
    return Walker::start(request, parameters, scene);
  }
  PlanReport plan(const Request&, const Parameters& parameters, const PreparedScene&, PlanContext& context) override {
    if (!context.emit(step(0))) return stopped();
    maybe_throw(parameters, "plan");
    return reached(1);
  }
  StepVerdict check(const Step& step, const Posture& before, const Parameters& parameters,
                    const PreparedScene& scene) const override {
    maybe_throw(parameters, "check");
    return Walker::check(step, before, parameters, scene);
  }
};

constexpr std::array kParameters = {
    ParameterSpec{"in", ParameterKind::kChoice, "", "plan", 0, 0, "prepare|start|plan|check|nowhere", "Where it throws."},
    ParameterSpec{"what", ParameterKind::kChoice, "", "std", 0, 0, "std|int|bad_alloc|request|scene", "What it throws."},
    ParameterSpec{"field", ParameterKind::kText, "", "goal.base", 0, 0, "", "The field of an InvalidRequest."}};

}  // namespace

FOOTHOLD_EXPORT_PLANNER(Throw, (foothold::PlannerInfo{.name = "throw",
                                                      .version = "1.0.0",
                                                      .prepare_parameters = "in|what",
                                                      .parameters = kParameters.data(),
                                                      .parameter_count = kParameters.size()}))
