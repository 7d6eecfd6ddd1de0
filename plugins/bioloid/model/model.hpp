// Bioloid's numbers, as config/robots/bioloid.yaml or a URDF gives them: a tree of 18 joints that carries 19 bodies.
//
// Every body has a frame that is parallel to the torso's in the zero pose, X forward, Y left, Z up, origin on its joint (the
// torso's: the pelvis). Joint angles count about `axis` by the right hand. Index of a joint = the servo's ID - 1: even indices are
// right (IDs odd), odd ones left. Metres, radians, kilograms. Immutable after loading: any thread.
#pragma once

#include <array>
#include <bitset>
#include <string>
#include <vector>

#include "foothold/model.hpp"
#include "foothold/types.hpp"
#include "kinematics/biped_leg.hpp"
#include "kinematics/planar_mechanism.hpp"
#include "kinematics/screw.hpp"

namespace foothold::bioloid {

inline constexpr std::size_t kJoints = 18, kBodies = kJoints + 1, kLegJoints = 6;
inline constexpr const char* kJointNames =
    "r_shoulder_pitch|l_shoulder_pitch|r_shoulder_roll|l_shoulder_roll|r_elbow|l_elbow|r_hip_yaw|l_hip_yaw|r_hip_roll|l_hip_roll|"
    "r_hip_pitch|l_hip_pitch|r_knee|l_knee|r_ankle_pitch|l_ankle_pitch|r_ankle_roll|l_ankle_roll";
inline constexpr const char* kLimbs = "right_foot|left_foot";

using Joints = Eigen::Matrix<double, static_cast<int>(kJoints), 1>;

enum class Side : std::size_t { kRight = 0, kLeft = 1 };
constexpr Side other(Side side) { return side == Side::kRight ? Side::kLeft : Side::kRight; }
constexpr std::size_t index_of(Side side) { return static_cast<std::size_t>(side); }
// Index of a leg's joint in Joints, hip yaw 0 to ankle roll 5.
constexpr std::size_t leg_joint(Side side, std::size_t k) { return 6 + 2 * k + index_of(side); }

struct BodyBox {
  Vector3d centre = Vector3d::Zero();  // in the body's frame; axes parallel to it
  Vector3d half = Vector3d::Zero();
};

struct Body {
  std::string name;  // right ones begin with r_, left ones with l_
  double mass = 0.0;
  Vector3d centre_of_mass = Vector3d::Zero();  // in the body's frame
  std::vector<BodyBox> boxes;                  // what collides is what is drawn
};

struct JointModel {
  int parent = -1;                     // the joint that carries it; -1: the torso
  Vector3d origin = Vector3d::Zero();  // in the parent's frame
  Vector3d axis = Vector3d::UnitZ();   // unit
  kinematics::Interval limits;         // rad
  double speed = 0.0;                  // rad/s, of the servo without load
};

struct Model {
  std::array<JointModel, kJoints> joints;
  std::array<Body, kBodies> bodies;            // [0]: torso; [i + 1]: what joint i moves
  Vector3d ankle_to_sole = Vector3d::Zero();   // from the ankle to the sole's centre in the zero pose (right; left mirrored in Y)
  double sole_length = 0.0, sole_width = 0.0;  // m
  Joints carrying = Joints::Zero();            // how the arms are held on a walk; legs 0

  double mass() const;
  // Leg of a side in closed form, its hip in the torso's frame, and the sign by which each servo counts against BipedLeg.
  const kinematics::BipedLeg& leg() const { return leg_; }
  Vector3d hip(Side side) const { return hips_[index_of(side)]; }
  Vector3d sole(Side side) const;  // from the ankle's centre to the sole's, in the foot's frame
  double sign(Side side, std::size_t k) const { return signs_[index_of(side)][k]; }
  // Bodies that are not judged against each other: joined by one joint, or by two whose axes meet. Symmetric; with itself too.
  bool neighbours(std::size_t a, std::size_t b) const { return neighbours_[a][b]; }

  // Numbers, or `urdf` (model/urdf.hpp). Throws InvalidModel with the entry's path: something missing, not of the structure above
  // (axes that do not meet in the hip or the ankle, legs that are not mirrored).
  static Model from_model(const RobotModel& model);

  kinematics::BipedLeg leg_;
  std::array<Vector3d, 2> hips_;
  std::array<std::array<double, kLegJoints>, 2> signs_{};
  std::array<std::bitset<kBodies>, kBodies> neighbours_{};
};

// Of names that stand in one string with | between them, the one at `index`.
std::string name_at(const char* names, std::size_t index);
// A posture's angle of the other side's joint: turns about Y are the same, those about X and Z count against each other.
double mirrored(const JointModel& joint, double angle);

}  // namespace foothold::bioloid
