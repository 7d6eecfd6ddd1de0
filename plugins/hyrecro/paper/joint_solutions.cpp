#include "hyrecro/paper/joint_solutions.hpp"

namespace foothold::hyrecro {

JointSolutions::JointSolutions(const Model& model, const PreparedTruss& scene, Reachability& asked)
    : model_(model), scene_(scene), asked_(asked) {}

bool JointSolutions::admits(const Isometry3d& holding, const Coordinates& coordinates) const {
  return scene_.obstacles.free(bodies_at(model_, coordinates, holding), scene_.clearance);
}

Reachability& JointSolutions::exact() {
  if (!exact_) exact_ = make_exact(model_, scene_.clearance);
  return *exact_;
}

Answer JointSolutions::solve(const Isometry3d& holding, const Isometry3d& free) {
  ++count_;
  const Isometry3d pose = holding.inverse() * free;
  const Admit admit = [&](const Coordinates& coordinates) { return admits(holding, coordinates); };
  const Reach reach = asked_.reach(pose, admit);
  if (!reach.reachable || reach.coordinates) return {reach.reachable, reach.coordinates};
  if (const Reach solved = exact().reach(pose, admit); solved.reachable) return {true, solved.coordinates};
  // Reachable but for the scene: the configuration collides.
  if (exact().reach(pose, {}).reachable) return {};
  return {true, std::nullopt};
}

Coordinates JointSolutions::nearest(const Isometry3d& free_in_holding) {
  constexpr double kStep = 0.01;  // m
  constexpr int kSteps = 20;
  for (int n = 0; n <= kSteps; ++n)
    for (int axis = 0; axis < (n == 0 ? 1 : 3); ++axis)
      for (const double sign : {-1.0, 1.0}) {
        Isometry3d pose = free_in_holding;
        pose.translation()[axis] += sign * n * kStep;
        if (const Reach reach = exact().reach(pose, {}); reach.reachable) return *reach.coordinates;
      }
  // Both legs straight at mid stroke.
  const kinematics::Interval strokes = model_.mechanism.offsets(0.0);
  const double middle = 0.5 * (strokes.low + strokes.high);
  return {{Leg{0.0, middle, 0.0, middle}, Leg{0.0, middle, 0.0, middle}}, {0.0, 0.0}};
}

}  // namespace foothold::hyrecro
