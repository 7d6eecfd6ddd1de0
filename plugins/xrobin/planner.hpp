// The planner of Xrobin: requests to routes to steps.
//
// Parameters are in schema.hpp, the searches in solver.hpp; every step is judged by check.hpp.
#pragma once

#include <memory>

#include "body.hpp"
#include "foothold/planner.hpp"
#include "route.hpp"
#include "solver.hpp"

namespace foothold::xrobin {

// Used by one thread at a time.
class XrobinPlanner final : public Planner {
 public:
  explicit XrobinPlanner(const RobotModel& model);

  std::shared_ptr<const PreparedScene> prepare(const Scene& scene, const Parameters& parameters) override;
  Posture start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const override;
  PlanReport plan(const Request& request, const Parameters& parameters, const PreparedScene& scene, PlanContext& context) override;
  StepVerdict check(const Step& step, const Posture& before, const Parameters& parameters,
                    const PreparedScene& scene) const override;
  std::vector<Shape> shapes(const Posture& posture) const override;

 private:
  // What depends on the robot alone. False if stopped.
  bool make_tables(const Parameters& parameters, bool obstacles, const std::stop_token& stop);

  Mechanism mechanism_;
  Ring ring_;
  Bodies bodies_;
  double stroke_time_;  // s
  Solver solver_;
};

}  // namespace foothold::xrobin
