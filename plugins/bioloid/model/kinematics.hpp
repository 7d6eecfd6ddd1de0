// Bioloid as a chain, closed both ways: by screws forward (paper, eq. 16), in closed form back. This is the plain form, for
// checking, drawing and key postures; the search's is posture/. Metres and radians. Values; any thread.
//
// A sole's frame: origin in its centre on the ground, X to the toes, Y left, Z up.
#pragma once

#include <optional>

#include "bioloid/model/model.hpp"

namespace foothold::bioloid {

struct Coordinates {
  Isometry3d pelvis = Isometry3d::Identity();  // torso's frame in the world
  Joints joints = Joints::Zero();
};

// Frames of all bodies in the torso's frame: [0] the torso's own, [i + 1] that of joint i's body.
std::array<Isometry3d, kBodies> body_frames(const Model& model, const Joints& joints);
// A sole in the torso's frame.
Isometry3d sole_in_torso(const Model& model, Side side, const Joints& joints);
// Of the whole robot, in the torso's frame.
Vector3d centre_of_mass(const Model& model, const Joints& joints);

bool within_limits(const Model& model, const Joints& joints);
// Puts the leg's six joints that bring its sole to `sole` (in the torso's frame) on the walking branch into `joints`. False if out
// of reach; limits are not looked at.
bool reach(const Model& model, Side side, const Isometry3d& sole, Joints& joints);
// All branches, as servo angles.
std::vector<Eigen::Matrix<double, 6, 1>> reach_all(const Model& model, Side side, const Isometry3d& sole);

// To and from the interface's posture: base is the torso.
Posture to_posture(const Coordinates& at);         // without stance
Coordinates from_posture(const Posture& posture);  // Precondition: 18 joints.
std::vector<Shape> shapes(const Model& model, const Coordinates& at);

}  // namespace foothold::bioloid
