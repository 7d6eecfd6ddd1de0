#include "hyrecro/paper/joint_solutions.hpp"

#include <cmath>

#include "hyrecro/motion/lift.hpp"
#include "hyrecro/reach/exact.hpp"
#include "hyrecro/reach/inverse.hpp"

namespace foothold::hyrecro {

JointSolutions::JointSolutions(const Model& model, const PreparedTruss& scene, Reachability& asked, double lift,
                               ByPoses<Answer>* kept)
    : model_(model),
      scene_(scene),
      asked_(asked),
      lift_(lift),
      repeats_(dynamic_cast<const Exact*>(&asked) != nullptr),
      kept_(repeats_ ? kept : nullptr) {}

JointSolutions::PoseKey JointSolutions::key_of(const Isometry3d& pose) {
  PoseKey key{};
  const Eigen::Matrix<double, 3, 4> rows = pose.matrix().topRows<3>();
  for (std::size_t k = 0; k < key.size(); ++k)
    key[k] = static_cast<int>(std::lround(1e8 * rows(static_cast<Eigen::Index>(k % 3), static_cast<Eigen::Index>(k / 3))));
  return key;
}

bool JointSolutions::admits(const Isometry3d& holding, const Coordinates& coordinates) const {
  return scene_.obstacles.free(bodies_at(model_, coordinates, holding), scene_.clearance);
}

Reachability& JointSolutions::exact() {
  if (!exact_) exact_ = make_exact(model_, scene_.clearance);
  return *exact_;
}

Answer JointSolutions::solve(const Isometry3d& holding, const Isometry3d& free) {
  ++count_;
  // Most of what the transition search asks for lies further beside the foot than the hip plate is long; so said without a look.
  if (repeats_) {
    const Isometry3d pose = holding.inverse() * free;
    if (std::fabs(pose.translation().y()) > model_.hip_distance && singular(pose)) return {};
  }
  return kept_ != nullptr ? kept_->get(holding, free, [&] { return ask(holding, free); }) : ask(holding, free);
}

Answer JointSolutions::ask(const Isometry3d& holding, const Isometry3d& free) {
  const Isometry3d pose = holding.inverse() * free;
  const PoseKey key = repeats_ ? key_of(pose) : PoseKey{};
  if (repeats_ && out_of_reach_.contains(key)) return {};
  bool offered = false;
  const Admit admit = [&](const Coordinates& coordinates) {
    offered = true;
    return legs_lift(model_, coordinates, lift_) && admits(holding, coordinates);
  };
  const Reach reach = asked_.reach(pose, admit);
  if (repeats_ && !reach.reachable && !offered) out_of_reach_.insert(key);
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
