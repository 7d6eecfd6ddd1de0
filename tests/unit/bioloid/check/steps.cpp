// The pelvis is found by moving it until the centre of mass is where it should be.
#include "steps.hpp"

#include <stdexcept>

namespace foothold::bioloid::testing {
namespace {

using Eigen::Vector2d;

Isometry3d at(const Vector3d& place, double heading) {
  return Eigen::Translation3d(place) * Isometry3d(Eigen::AngleAxisd(heading, Vector3d::UnitZ()));
}

double heading_of(const Isometry3d& frame) { return std::atan2(frame.linear()(1, 0), frame.linear()(0, 0)); }

}  // namespace

Coordinates standing_with(const Model& model, const Isometry3d& right, const Isometry3d& left, const Vector2d& centre,
                          double pelvis, double heading) {
  Coordinates out;
  out.joints = model.carrying;
  out.pelvis = at({centre.x(), centre.y(), pelvis}, heading);
  for (int i = 0; i < 30; ++i) {
    if (!reach(model, Side::kRight, out.pelvis.inverse() * right, out.joints) ||
        !reach(model, Side::kLeft, out.pelvis.inverse() * left, out.joints))
      throw std::runtime_error("out of reach");
    const Vector3d found = out.pelvis * centre_of_mass(model, out.joints);
    if (i + 1 < 30) out.pelvis.translation().head<2>() += centre - found.head<2>();
  }
  return out;
}

Posture standing(const Model& model, double pelvis) {
  const auto place = [&](Side side) {
    const Vector3d sole = sole_in_torso(model, side, Joints::Zero()).translation();
    return at({0, sole.y(), 0}, 0);
  };
  const Isometry3d right = place(Side::kRight), left = place(Side::kLeft);
  Posture out = to_posture(standing_with(model, right, left, Vector2d::Zero(), pelvis, 0.0));
  out.stance = {{"right_foot", right, ""}, {"left_foot", left, ""}};
  return out;
}

Step step_after(const Model& model, const Posture& before, const StepOrder& order) {
  const std::size_t moving = index_of(order.moving);
  const Isometry3d fast = before.stance[1 - moving].frame, old = before.stance[moving].frame;
  const Isometry3d place = old * at({order.forward, 0, 0}, order.turn);
  const Vector2d outwards = (order.moving == Side::kLeft ? -1.0 : 1.0) * fast.linear().col(1).head<2>();
  const Vector2d over = fast.translation().head<2>() + order.beside * outwards;
  const Vector2d begin = 0.5 * (fast.translation() + old.translation()).head<2>();
  const Vector2d end = 0.5 * (fast.translation() + place.translation()).head<2>();
  const double from_heading = heading_of(before.base), to_heading = 0.5 * (heading_of(fast) + heading_of(place));

  Step step;
  const auto add = [&](const Isometry3d& sole, const Vector2d& centre, double heading) {
    const Isometry3d& right = order.moving == Side::kRight ? sole : fast;
    const Isometry3d& left = order.moving == Side::kRight ? fast : sole;
    const Coordinates now = standing_with(model, right, left, centre, order.pelvis, heading);
    const Posture posture = to_posture(now);
    step.motion.push_back({0.04 * static_cast<double>(step.motion.size()), posture.base, posture.joints});
  };
  constexpr int kShift = 30, kLift = 6, kOver = 20;
  for (int i = 0; i <= kShift; ++i) add(old, begin + (over - begin) * i / kShift, from_heading);
  for (int i = 1; i <= kLift; ++i) add(Eigen::Translation3d(0, 0, order.lift * i / kLift) * old, over, from_heading);
  for (int i = 1; i <= kOver; ++i) {
    const double t = static_cast<double>(i) / kOver;
    add(Eigen::Translation3d(0, 0, order.lift) * old * at({order.forward * t, 0, 0}, order.turn * t), over,
        from_heading + t * (to_heading - from_heading));
  }
  for (int i = kLift; i-- > 0;) add(Eigen::Translation3d(0, 0, order.lift * i / kLift) * place, over, to_heading);
  for (int i = 1; i <= kShift; ++i) add(place, over + (end - over) * i / kShift, to_heading);

  step.motion.front().joints = before.joints;
  step.motion.front().base = before.base;
  step.after = Posture{step.motion.back().base, step.motion.back().joints, before.stance};
  step.after.stance[moving].frame = place;
  step.placed = {step.after.stance[moving]};
  return step;
}

}  // namespace foothold::bioloid::testing
