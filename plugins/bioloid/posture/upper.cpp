// Torso and arms by their chain.
#include "bioloid/posture/upper.hpp"

#include <algorithm>

#include "bioloid/posture/planes.hpp"
#include "kinematics/screw.hpp"

namespace foothold::bioloid {
namespace {

bool apart(const Model& model, const Upper& upper, double clearance) {
  for (std::size_t i = 0; i < upper.parts.size(); ++i)
    for (std::size_t j = i + 1; j < upper.parts.size(); ++j)
      if (!model.neighbours(upper.parts[i].body, upper.parts[j].body) &&
          collision::nearer(upper.parts[i].box, upper.parts[j].box, clearance))
        return false;
  return true;
}

struct Beside {
  Vector3d normal = Vector3d::Zero(), centre = Vector3d::Zero();
  double offset = 0.0;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
};

// The face's plane that leaves the arm beyond it and the leg, stretched down from its hip, farthest on this side; and the box.
Beside beside(const Model& model, Side side, const Upper& upper) {
  const Vector3d hip = model.hip(side), foot = hip + model.leg().thigh + model.leg().shin + model.sole(side);
  std::vector<collision::Box> arm;
  for (const Upper::Part& part : upper.parts)
    if (part.body > 0 && (part.body - 1) % 2 == index_of(side)) arm.push_back(part.box);
  Beside out;
  out.offset = 1e9;  // no arm: the plane is far away
  if (arm.empty()) return out;
  const auto extent = [&](const Vector3d& n) {
    double least = 1e9;
    for (const collision::Box& box : arm) least = std::min(least, least_along(box, n));
    return least;
  };
  double best = -1e9;
  for (const collision::Box& box : arm)
    for (int k = 0; k < 6; ++k) {
      const Vector3d n = (k < 3 ? 1.0 : -1.0) * box.pose.linear().col(k % 3);
      const double offset = extent(n), room = offset - std::max(n.dot(hip), n.dot(foot));
      if (room <= best) continue;
      best = room;
      out.normal = n;
      out.offset = offset;
    }
  for (int k = 0; k < 3; ++k) {
    const Vector3d n = arm[0].pose.linear().col(k);
    const double low = extent(n), high = -extent(-n);
    out.centre += 0.5 * (low + high) * n;
    out.axes.col(k) = 0.5 * (high - low) * n;
  }
  return out;
}

}  // namespace

Upper upper_of(const Model& model, const Arms& arms, double clearance) {
  Upper out;
  out.arms = arms;
  auto& frames = out.frames;
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
  const Beside right = beside(model, Side::kRight, out), left = beside(model, Side::kLeft, out);
  out.arm_plane = lanes(right.normal, left.normal);
  out.arm_offset = Lanes{right.offset, left.offset};
  out.arm_centre = lanes(right.centre, left.centre);
  for (int k = 0; k < 3; ++k) out.arm_axes[static_cast<std::size_t>(k)] = lanes(right.axes.col(k), left.axes.col(k));
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
