// The planner of Bioloid: requests to footsteps to certified strides to steps.
//
// Parameters are in schema.hpp, what a request may ask in request.hpp, footsteps in steps/, strides in gait/, the search's judge in
// posture/, the paper's algorithms in paper/; every step is judged by check/.
#pragma once

#include "bioloid/request.hpp"
#include "foothold/planner.hpp"

namespace foothold::bioloid {

// Used by one thread at a time.
class BioloidPlanner final : public Planner {
 public:
  explicit BioloidPlanner(const RobotModel& model);

  // Takes plane scenes; without a scene the ground is free.
  std::shared_ptr<const PreparedScene> prepare(const Scene& scene, const Parameters& parameters) override;
  Posture start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const override;
  // A step is one placement with the motion from standing to standing; all are sent when the walk is known to its end.
  PlanReport plan(const Request& request, const Parameters& parameters, const PreparedScene& scene, PlanContext& context) override;
  StepVerdict check(const Step& step, const Posture& before, const Parameters& parameters,
                    const PreparedScene& scene) const override;
  std::vector<Shape> shapes(const Posture& posture) const override;

 private:
  Model model_;
};

}  // namespace foothold::bioloid
