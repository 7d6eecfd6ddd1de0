// Torso and arms by their chain.
#include "bioloid/posture/upper.hpp"

#include <algorithm>

#include "kinematics/screw.hpp"

namespace foothold::bioloid {
namespace {

double least_along(const collision::Box& box, const Vector3d& n) {
  return n.dot(box.pose.translation()) - (box.pose.linear().transpose() * n).cwiseAbs().dot(box.half);
}

bool apart(const Model& model, const Upper& upper, double clearance) {
  for (std::size_t i = 0; i < upper.parts.size(); ++i)
    for (std::size_t j = i + 1; j < upper.parts.size(); ++j)
      if (!model.neighbours(upper.parts[i].body, upper.parts[j].body) &&
          collision::nearer(upper.parts[i].box, upper.parts[j].box, clearance))
        return false;
  return true;
}

// The face's plane that leaves the arm beyond it and the leg, stretched down from its hip, farthest on this side.
void choose_plane(const Model& model, Side side, Upper& upper) {
  const Vector3d hip = model.hip(side), foot = hip + model.leg().thigh + model.leg().shin + model.sole(side);
  double best = -1e9;
  const auto is_arm = [&](const Upper::Part& part) { return part.body > 0 && (part.body - 1) % 2 == index_of(side); };
  for (const Upper::Part& of : upper.parts) {
    if (!is_arm(of)) continue;
    for (int k = 0; k < 6; ++k) {
      const Vector3d n = (k < 3 ? 1.0 : -1.0) * of.box.pose.linear().col(k % 3);
      double offset = 1e9;
      for (const Upper::Part& part : upper.parts)
        if (is_arm(part)) offset = std::min(offset, least_along(part.box, n));
      const double room = offset - std::max(n.dot(hip), n.dot(foot));
      if (room <= best) continue;
      best = room;
      upper.normal[index_of(side)] = n;
      upper.offset[index_of(side)] = offset;
    }
  }
}

}  // namespace

Upper upper_of(const Model& model, const Arms& arms, double clearance) {
  Upper out;
  out.arms = arms;
  std::array<Isometry3d, kArmJoints + 1> frames;
  frames[0] = Isometry3d::Identity();
  out.lowest = 1e9;
  for (std::size_t b = 0; b <= kArmJoints; ++b) {
    if (b > 0) {
      const JointModel& joint = model.joints[b - 1];
      frames[b] = frames[static_cast<std::size_t>(joint.parent + 1)] *
                  kinematics::displacement({joint.axis, joint.origin}, arms[static_cast<int>(b - 1)]) *
                  Eigen::Translation3d(joint.origin);
    }
    const Body& body = model.bodies[b];
    out.moment += body.mass * (frames[b] * body.centre_of_mass);
    for (const BodyBox& box : body.boxes) {
      out.parts.push_back({b, {frames[b] * Eigen::Translation3d(box.centre), box.half}});
      const collision::Box& placed = out.parts.back().box;
      out.reach = std::max(out.reach, placed.pose.translation().norm() + placed.half.norm());
      if (b == 0) out.lowest = std::min(out.lowest, least_along(placed, Vector3d::UnitZ()));
    }
    if (b == 0) out.torso_parts = out.parts.size();
  }
  for (const Side side : {Side::kRight, Side::kLeft}) choose_plane(model, side, out);
  out.apart = apart(model, out, clearance);
  return out;
}

double arm_reach(const Model& model) {
  double longest = 0.0;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    double length = 0.0;
    for (std::size_t j = index_of(side); j < kArmJoints; j += 2) {
      if (model.joints[j].parent >= 0) length += model.joints[j].origin.norm();
      for (const BodyBox& box : model.bodies[j + 1].boxes)
        longest = std::max(longest, length + box.centre.norm() + box.half.norm());
      longest = std::max(longest, length + model.bodies[j + 1].centre_of_mass.norm());
    }
  }
  return longest;
}

}  // namespace foothold::bioloid
