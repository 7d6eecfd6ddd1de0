// The chain of HyReCRo from sole to sole: joints, coordinates, forward kinematics.
//
// Paper's frames (Y out of the surface, Z along the planar mechanisms' axes, X forward) are used inside chain.cpp only; everything
// that other files see is in the frames of the interface: +Z out of the surface, +X forward, so Y_wire = -Z_paper. A leg: L_j =
// Ty(a) Rz(phi1) Ty(lambda) Rz(phi2) Ty(a2), lambda = y1 + y2 - h, psi = phi1 + phi2 (paper's frames). The robot: T_0_1 = L_0
// Ry(hip0) Tx(t) Ry(-hip1) L_1^-1; "0" is the foot that one looks from, in this plugin always the one that holds. Values; any
// thread.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "hyrecro/model/model.hpp"

namespace foothold::hyrecro {

// One leg: the ankle's mechanism (phi1, y1) and the upper one (phi2, y2).
struct Leg {
  double phi1 = 0.0, y1 = 0.0, phi2 = 0.0, y2 = 0.0;  // rad, m
  double psi() const { return phi1 + phi2; }
};

// The ten coordinates, one for each actuator, but with each pair of lengths as (phi, y). leg[0] and hip[0] belong to the foot that
// one looks from.
struct Coordinates {
  std::array<Leg, 2> leg;
  std::array<double, 2> hip{0.0, 0.0};  // rad; without stops, equal modulo 2 pi
};

// Which foot is which: as the limbs of the interface are called.
enum class Foot { kA = 0, kB = 1 };
inline Foot other(Foot foot) { return foot == Foot::kA ? Foot::kB : Foot::kA; }
const char* name_of(Foot foot);  // "A", "B"

// The same posture seen from the other foot: legs change places, both hip angles grow by pi (and are taken into (-pi, pi]).
Coordinates swapped(const Coordinates& coordinates);

// Into [-pi, pi], rad.
inline double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

// Pose of sole 1 seen from sole 0.
Isometry3d forward(const Model& model, const Coordinates& coordinates);

// lambda = y1 + y2 - h, m.
double leg_length(const Model& model, const Leg& leg);

// Poses of what the bodies hang on, seen from sole 0. Each leg's line begins at its ankle pin and ends at its upper pin.
struct Frames {
  std::array<Isometry3d, 2> sole;
  std::array<Vector3d, 2> ankle_pin;
  std::array<Vector3d, 2> upper_pin;
  Isometry3d hip;  // origin in the middle between the hip axes, X from axis 0 to axis 1, Z along the axes (out of the surface when
                   // legs are straight)
};
Frames frames(const Model& model, const Coordinates& coordinates);

// All actuators keep their limits within `tolerance` (m).
bool within_limits(const Model& model, const Coordinates& coordinates, double tolerance = 1e-9);

// The joints that leave the server: A_l1, A_r1, A_l2, A_r2, B_l1, B_r1, B_l2, B_r2 (m), hip_A, hip_B (rad). `first`: which foot
// `coordinates` look from.
inline constexpr const char* kJointNames = "A_l1|A_r1|A_l2|A_r2|B_l1|B_r1|B_l2|B_r2|hip_A|hip_B";
inline constexpr std::size_t kJoints = 10;
std::vector<double> to_joints(const Model& model, const Coordinates& coordinates, Foot first);
// Precondition: joints.size() == kJoints and the lengths are within the limits by 1e-6 m.
Coordinates from_joints(const Model& model, std::span<const double> joints, Foot first);

}  // namespace foothold::hyrecro
