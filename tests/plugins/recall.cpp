// Tells what it was given, and how often it had to prepare: scene, thread, random numbers.
#include "walker.hpp"

namespace {

using namespace foothold;

struct Prepared : PreparedScene {
  Prepared(int number_, Scene scene_) : number(number_), scene(std::move(scene_)) {}
  std::vector<Shape> shapes() const override { return {{.kind = Shape::Kind::kBox, .body = scene.name, .size = {1.0, 2.0, 3.0}}}; }
  int number;
  Scene scene;
};

class Recall : public test::Walker {
 public:
  using Walker::Walker;

  std::shared_ptr<const PreparedScene> prepare(const Scene& scene, const Parameters&) override {
    return std::make_shared<const Prepared>(++prepared_, scene);
  }
  PlanReport plan(const Request& request, const Parameters&, const PreparedScene& scene, PlanContext& context) override {
    const auto& prepared = dynamic_cast<const Prepared&>(scene);
    Step first = step(0);
    first.attributes = {{"prepared", std::to_string(prepared.number)},
                        {"path", prepared.scene.path},
                        {"unit", request.unit},
                        {"seed", std::to_string(request.seed)},
                        {"budget", std::to_string(request.budget)},
                        {"goal", request.goal.base ? std::to_string(request.goal.base->translation().y()) : "none"},
                        {"random", std::to_string(context.random())}};
    if (!context.emit(std::move(first))) return stopped();
    return reached(1);
  }

 private:
  int prepared_ = 0;
};

constexpr std::array kParameters = {
    ParameterSpec{"grid", ParameterKind::kReal, "m", "0.1", 0.01, 1, "", "What prepare() depends on."},
    ParameterSpec{"other", ParameterKind::kFlag, "", "false", 0, 0, "", "What it does not depend on."}};

}  // namespace

FOOTHOLD_EXPORT_PLANNER(Recall, (foothold::PlannerInfo{.name = "recall",
                                                       .version = "1.0.0",
                                                       .prepare_parameters = "grid",
                                                       .parameters = kParameters.data(),
                                                       .parameter_count = kParameters.size()}))
