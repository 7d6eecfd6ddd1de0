// The planner of Hex-piderix: requests to adaptions to steps.
//
// Parameters are in schema.hpp, what a request may ask in request.hpp, the methods in adapt/, strategies/ and optimal/; every step
// is judged by check/.
#pragma once

#include "foothold/planner.hpp"
#include "hexpiderix/request.hpp"

namespace foothold::hexpiderix {

// Used by one thread at a time.
class HexpiderixPlanner final : public Planner {
 public:
  explicit HexpiderixPlanner(const RobotModel& model);

  // Takes terrains: yaml, stl, obj or ply. Throws InvalidScene without a scene, too.
  std::shared_ptr<const PreparedScene> prepare(const Scene& scene, const Parameters& parameters) override;
  Posture start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const override;
  // Without a goal the robot adapts where it stands: one step. With one it walks: a step is half a cycle, and all are sent when the
  // way is known to the end.
  PlanReport plan(const Request& request, const Parameters& parameters, const PreparedScene& scene, PlanContext& context) override;
  StepVerdict check(const Step& step, const Posture& before, const Parameters& parameters,
                    const PreparedScene& scene) const override;
  std::vector<Shape> shapes(const Posture& posture) const override;

 private:
  PlanReport plan_walk(const Request& request, const Options& options, const Ground& ground, PlanContext& context) const;

  Model model_;
};

}  // namespace foothold::hexpiderix
