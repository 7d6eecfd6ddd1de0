// The planner of HyReCRo: requests to routes to motions to steps.
//
// Parameters are in schema.hpp, what a request may ask in request.hpp, the searches in optimal/ and paper/, the motions in motion/;
// every step is judged by check/.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "foothold/planner.hpp"
#include "hyrecro/reach/reachability.hpp"
#include "hyrecro/request.hpp"

namespace foothold::hyrecro {

// A posture to begin with: `holding` holds; the other foot stands as well (`stands`) or is in the air.
struct Beginning {
  Grip holding;
  Coordinates coordinates;  // seen from it
  bool stands = false;
};

// Used by one thread at a time.
class HyrecroPlanner final : public Planner {
 public:
  explicit HyrecroPlanner(const RobotModel& model);

  // Takes trusses: yaml, stl, obj or ply. Throws InvalidScene without a scene, too.
  std::shared_ptr<const PreparedScene> prepare(const Scene& scene, const Parameters& parameters) override;
  Posture start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const override;
  PlanReport plan(const Request& request, const Parameters& parameters, const PreparedScene& scene, PlanContext& context) override;
  StepVerdict check(const Step& step, const Posture& before, const Parameters& parameters,
                    const PreparedScene& scene) const override;
  std::vector<Shape> shapes(const Posture& posture) const override;

 private:
  // Made once for the same steps, clearance and room to lift, whatever the scene. Null if stopped.
  std::shared_ptr<const PlanarWorkspace> workspace(const Options& options, const std::stop_token& stop);
  Reachability& exact(double clearance) const;
  // One for a robot on one foot, one for each foot that may stay for one on both: then, unless the request gives joints, in a
  // posture from which either foot can rise, if there is one.
  std::vector<Beginning> beginnings(const Request& request, const PreparedTruss& scene, const Options& options) const;
  Posture standing(const std::vector<Beginning>& from, const PreparedTruss& truss) const;
  Found search(const Options& options, const PreparedTruss& scene, const Grip& from, const Foothold& goal, double budget,
               PlanContext& context);
  Found optimal(const Options& options, const PreparedTruss& scene, const Grip& from, const Foothold& goal, double budget,
                const std::stop_token& stop);

  Model model_;
  struct WorkspaceKey {
    double position_step, heading_step, clearance, lift;
    auto operator<=>(const WorkspaceKey&) const = default;
  };
  std::map<WorkspaceKey, std::shared_ptr<const PlanarWorkspace>> workspaces_;
  mutable std::map<double, std::unique_ptr<Reachability>> exact_;  // by clearance
};

}  // namespace foothold::hyrecro
