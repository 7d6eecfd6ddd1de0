// Phases, one after the other, as one motion of the torso and 18 joints.
#include "bioloid/sending.hpp"

#include <cstdio>

namespace foothold::bioloid {
namespace {

Contact contact_of(Side side, const PlanarPose& sole) { return {name_at(kLimbs, index_of(side)), to_world(sole), ""}; }

std::vector<double> values(const Joints& joints) { return {joints.data(), joints.data() + joints.size()}; }

class Motion {
 public:
  explicit Motion(const Model& model) : model_(model) {}

  // What comes from another piece may differ in rounding from where the last one ended: the last one's stays.
  void add(const Phase& phase, Side support, const PlanarPose& sole) {
    for (std::size_t k = points_.empty() ? 0 : 1; k < phase.points.size(); ++k)
      points_.push_back({begin_ + phase.times[k], torso(support, sole, phase.points[k]), values(phase.points[k])});
    begin_ += phase.times.back();
  }
  Isometry3d torso(Side support, const PlanarPose& sole, const Joints& joints) const {
    return to_world(sole) * sole_in_torso(model_, support, joints).inverse();
  }
  std::vector<MotionPoint> take() { return std::move(points_); }

 private:
  const Model& model_;
  std::vector<MotionPoint> points_;
  double begin_ = 0.0;
};

std::string label_of(const WalkStep& step, int number) {
  const PlanarPose &from = step.stride.from, &to = step.stride.to;
  char text[160];
  std::snprintf(text, sizeof text, "%d: %s foot %+.0f mm ahead, %+.0f mm to the left", number,
                step.stride.support == Side::kRight ? "left" : "right", 1e3 * (to.x - from.x), 1e3 * (to.y - from.y));
  std::string out = text;
  if (std::abs(wrapped(to.heading - from.heading)) > 1e-6) {
    std::snprintf(text, sizeof text, ", turned by %+.0f deg", wrapped(to.heading - from.heading) * 180.0 / M_PI);
    out += text;
  }
  return out;
}

}  // namespace

const char* words(Fault fault) {
  switch (fault) {
    case Fault::kNone:
      return "nothing";
    case Fault::kLimit:
      return "a joint would leave its limits, or a leg does not reach";
    case Fault::kSelf:
      return "bodies would come nearer to each other than the clearance";
    case Fault::kGround:
      return "a body or the moving sole would meet the ground";
    case Fault::kObstacle:
      return "a body would come nearer to an obstacle than the clearance";
    case Fault::kBalance:
      return "the centre of mass would come too near to the border of the soles that stand";
    case Fault::kSlip:
      return "a standing sole would be moved";
  }
  return "";
}

Posture standing_posture(const Model& model, const Feet& feet, const Joints& joints) {
  Posture out;
  out.base = to_world(feet.right) * sole_in_torso(model, Side::kRight, joints).inverse();
  out.joints = values(joints);
  out.stance = {contact_of(Side::kRight, feet.right), contact_of(Side::kLeft, feet.left)};
  return out;
}

Step to_step(const Model& model, const Stand& from, const Phase& rise) {
  Step out;
  out.label = "takes the posture to walk in";
  Motion motion(model);
  motion.add(rise, Side::kRight, from.feet.right);
  out.motion = motion.take();
  out.after = standing_posture(model, from.feet, rise.points.back());
  return out;
}

Step to_step(const Model& model, const Feet& before, Joints& joints, const WalkStep& step, int number) {
  Step out;
  out.label = label_of(step, number);
  const Side support = step.stride.support, moves = other(support);
  Motion motion(model);
  for (const Phase& phase : step.stride.phases) motion.add(phase, support, step.support);
  out.motion = motion.take();
  out.motion.front().joints = values(joints);
  out.motion.front().base = standing_posture(model, before, joints).base;
  joints = step.stride.phases.back().points.back();
  out.after = standing_posture(model, step.after, joints);
  out.after.base = out.motion.back().base;
  out.placed = {contact_of(moves, step.after.of(moves))};
  out.cost = number;
  return out;
}

}  // namespace foothold::bioloid
