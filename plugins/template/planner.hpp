// A complete small planner, to be copied: README.md. The fewest steps to a goal on flat ground, proved.
#pragma once

#include "biped.hpp"

namespace foothold::biped {

// Thread rule of every planner: one thread at a time.
class BipedPlanner final : public Planner {
 public:
  explicit BipedPlanner(const RobotModel& model) : biped_(model) {}

  std::shared_ptr<const PreparedScene> prepare(const Scene& scene, const Parameters& parameters) override;
  Posture start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const override;
  PlanReport plan(const Request& request, const Parameters& parameters, const PreparedScene& scene, PlanContext& context) override;
  StepVerdict check(const Step& step, const Posture& before, const Parameters& parameters,
                    const PreparedScene& scene) const override;
  std::vector<Shape> shapes(const Posture& posture) const override;

 private:
  Biped biped_;
};

}  // namespace foothold::biped
