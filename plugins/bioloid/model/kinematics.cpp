// The chain by screws forward, the leg in closed form back.
#include "bioloid/model/kinematics.hpp"

#include <stdexcept>

namespace foothold::bioloid {
namespace {

using Leg = kinematics::BipedLeg;

// From the torso to the leg's ankle: what its closed form is asked.
Isometry3d ankle_of(const Model& model, Side side, const Isometry3d& sole) {
  return Eigen::Translation3d(-model.hip(side)) * sole * Eigen::Translation3d(-model.sole(side));
}

Eigen::Matrix<double, 6, 1> servos(const Model& model, Side side, const Leg::Angles& angles) {
  Eigen::Matrix<double, 6, 1> out;
  for (std::size_t k = 0; k < kLegJoints; ++k) out[static_cast<int>(k)] = model.sign(side, k) * angles[static_cast<int>(k)];
  return out;
}

}  // namespace

std::array<Isometry3d, kBodies> body_frames(const Model& model, const Joints& joints) {
  std::array<Isometry3d, kBodies> frames;
  frames[0] = Isometry3d::Identity();
  for (std::size_t j = 0; j < kJoints; ++j) {
    const JointModel& joint = model.joints[j];
    // A turn about the joint's axis where the zero pose has it, then the frame's own place.
    const Isometry3d turn = kinematics::displacement({joint.axis, joint.origin}, joints[static_cast<int>(j)]);
    frames[j + 1] = frames[static_cast<std::size_t>(joint.parent + 1)] * turn * Eigen::Translation3d(joint.origin);
  }
  return frames;
}

Isometry3d sole_in_torso(const Model& model, Side side, const Joints& joints) {
  Leg::Angles angles;
  for (std::size_t k = 0; k < kLegJoints; ++k)
    angles[static_cast<int>(k)] = model.sign(side, k) * joints[static_cast<int>(leg_joint(side, k))];
  return Eigen::Translation3d(model.hip(side)) * model.leg().forward(angles) * Eigen::Translation3d(model.sole(side));
}

Vector3d centre_of_mass(const Model& model, const Joints& joints) {
  const auto frames = body_frames(model, joints);
  Vector3d moment = Vector3d::Zero();
  for (std::size_t b = 0; b < kBodies; ++b) moment += model.bodies[b].mass * (frames[b] * model.bodies[b].centre_of_mass);
  return moment / model.mass();
}

bool within_limits(const Model& model, const Joints& joints) {
  constexpr double kRounding = 1e-12;
  for (std::size_t j = 0; j < kJoints; ++j)
    if (!model.joints[j].limits.holds(joints[static_cast<int>(j)], kRounding)) return false;
  return true;
}

bool reach(const Model& model, Side side, const Isometry3d& sole, Joints& joints) {
  Leg::Angles angles;
  if (!model.leg().standing(ankle_of(model, side, sole), angles)) return false;
  for (std::size_t k = 0; k < kLegJoints; ++k)
    joints[static_cast<int>(leg_joint(side, k))] = model.sign(side, k) * angles[static_cast<int>(k)];
  return true;
}

std::vector<Eigen::Matrix<double, 6, 1>> reach_all(const Model& model, Side side, const Isometry3d& sole) {
  const Leg::Solutions found = model.leg().inverse(ankle_of(model, side, sole));
  std::vector<Eigen::Matrix<double, 6, 1>> out;
  for (int i = 0; i < found.count; ++i) out.push_back(servos(model, side, found.angles[static_cast<std::size_t>(i)]));
  return out;
}

Posture to_posture(const Coordinates& at) { return {at.pelvis, {at.joints.begin(), at.joints.end()}, {}}; }

Coordinates from_posture(const Posture& posture) {
  if (posture.joints.size() != kJoints) throw std::logic_error("a posture of Bioloid has 18 joints");
  return {posture.base, Eigen::Map<const Joints>(posture.joints.data())};
}

std::vector<Shape> shapes(const Model& model, const Coordinates& at) {
  const auto frames = body_frames(model, at.joints);
  std::vector<Shape> out;
  for (std::size_t b = 0; b < kBodies; ++b)
    for (const BodyBox& box : model.bodies[b].boxes)
      out.push_back(
          {Shape::Kind::kBox, model.bodies[b].name, at.pelvis * frames[b] * Eigen::Translation3d(box.centre), 2.0 * box.half, {}});
  return out;
}

}  // namespace foothold::bioloid
