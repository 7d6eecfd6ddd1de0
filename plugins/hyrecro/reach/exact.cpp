#include "hyrecro/reach/exact.hpp"

namespace foothold::hyrecro {
namespace {

// The plates are where the pose says, whatever the posture.
bool plates_apart(const Model& model, const Isometry3d& pose, double clearance) {
  const double thickness = model.plate.z() - model.skin;
  const Vector3d half = 0.5 * Vector3d(model.plate.x(), model.plate.y(), thickness);
  const double raised = model.skin + 0.5 * thickness;
  const auto plate = [&](const Isometry3d& sole) { return collision::Box{sole * Eigen::Translation3d(0.0, 0.0, raised), half}; };
  return !collision::nearer(plate(Isometry3d::Identity()), plate(pose), clearance);
}

}  // namespace

Exact::Exact(const Model& model, double clearance, const CellSearchOptions& options)
    : model_(model), clearance_(clearance), filter_(shared_reach_filter(model)), cells_(model, clearance, options) {}

bool Exact::for_each_solution(const Isometry3d& pose, const Offer& take) {
  if (!filter_->may_reach(pose) || !plates_apart(model_, pose, clearance_)) return false;
  return cells_.search(pose, take);
}

Reach Exact::reach(const Isometry3d& pose, const Admit& admit) {
  Reach out;
  out.reachable = for_each_solution(pose, [&](const Coordinates& coordinates) {
    if (admit && !admit(coordinates)) return false;
    out.coordinates = coordinates;
    return true;
  });
  return out;
}

std::unique_ptr<Reachability> make_exact(const Model& model, double clearance) { return std::make_unique<Exact>(model, clearance); }

}  // namespace foothold::hyrecro
