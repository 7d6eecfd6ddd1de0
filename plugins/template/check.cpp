// The judge of a step. It knows postures only, nothing of how the search found them: a mistake there must not be repeated here.
#include <cmath>

#include "planner.hpp"

namespace foothold::biped {
namespace {

constexpr double kSame = 1e-9;  // m, and of rotation matrices

StepVerdict refused(std::string reason) { return {.accepted = false, .reason = std::move(reason), .margins = {}}; }

bool same(const Isometry3d& a, const Isometry3d& b) { return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() <= kSame; }

}  // namespace

StepVerdict BipedPlanner::check(const Step& step, const Posture& before, const Parameters&, const PreparedScene&) const {
  const auto& stance = step.after.stance;
  if (stance.size() != 2 || before.stance.size() != 2)
    return refused("the robot stands on two feet, not on " + std::to_string(stance.size()));
  if (step.placed.size() != 1) return refused("one foot is placed at a time, not " + std::to_string(step.placed.size()));
  const Foot moved = step.placed[0].limb == kLimbs[kLeft] ? kLeft : kRight;
  const Foot held = moved == kLeft ? kRight : kLeft;
  if (!same(stance[moved].frame, step.placed[0].frame)) return refused("the placed foot does not stand where it was placed");
  if (!same(stance[held].frame, before.stance[held].frame)) return refused("the foot that carries the robot moves");
  if (std::abs(stance[moved].frame.translation().z()) > kSame) return refused("the foot is not on the ground");

  const Isometry3d& support = stance[held].frame;
  if (!stance[moved].frame.linear().isApprox(support.linear(), kSame)) return refused("the foot is turned");
  const Vector3d offset = support.inverse() * stance[moved].frame.translation();
  const double out = (offset - (biped_.rest(moved) - biped_.rest(held))).norm();
  const double gap = std::max(std::abs(offset.x()) - biped_.foot_length, std::abs(offset.y()) - biped_.foot_width);
  if (out > biped_.reach)
    return refused("the foot stands " + std::to_string(out) + " m from its rest, its reach is " + std::to_string(biped_.reach) +
                   " m");
  if (gap < 0.0) return refused("the soles overlap by " + std::to_string(-gap) + " m");
  const Vector3d middle = 0.5 * (stance[kLeft].frame.translation() + stance[kRight].frame.translation());
  if ((step.after.base.translation() - middle).norm() > kSame) return refused("the body is not in the middle between the feet");
  return {
      .accepted = true, .reason = {}, .margins = {{"reach", biped_.reach - out, 0.0, "m"}, {"gap between soles", gap, 0.0, "m"}}};
}

}  // namespace foothold::biped
