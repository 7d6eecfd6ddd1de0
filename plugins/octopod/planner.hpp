// The planner of the octopod: requests to routes to transitions to steps.
//
// Parameters are in schema.hpp, what a request may ask in request.hpp, the searches in search/, the motions in transition/; every
// step is judged by check/.
#pragma once

#include "foothold/planner.hpp"
#include "octopod/model/model.hpp"
#include "octopod/request.hpp"

namespace foothold::octopod {

// Used by one thread at a time.
class OctopodPlanner final : public Planner {
 public:
  explicit OctopodPlanner(const RobotModel& model);

  // Takes terrains: yaml, stl, obj or ply. Throws InvalidScene without a scene, too.
  std::shared_ptr<const PreparedScene> prepare(const Scene& scene, const Parameters& parameters) override;
  Posture start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const override;
  // Nothing is sent before the search is over: until then A* may still turn to another route. Then each step goes out as soon as
  // its motion is made.
  PlanReport plan(const Request& request, const Parameters& parameters, const PreparedScene& scene, PlanContext& context) override;
  StepVerdict check(const Step& step, const Posture& before, const Parameters& parameters,
                    const PreparedScene& scene) const override;
  std::vector<Shape> shapes(const Posture& posture) const override;

 private:
  Model model_;
};

}  // namespace foothold::octopod
