// Displacements by screws: a turn about a line in space, composed along a chain (Bioloid paper, eqs. 1 to 16; Tsai, Robot Analysis,
// section 2.4). Metres and radians. Values; any thread.
//
// The paper prints a11 = (sx^2 - 1)(1 - cos phi) + 1 and so on, and a14 = t sx - s0x (a11 - 1) - s0y a12 - s0z a13: Rodrigues'
// formula for a line through s0 along s.
#pragma once

#include <Eigen/Geometry>
#include <span>

namespace foothold::kinematics {

struct Screw {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // s, unit
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // s0, any point of the line
};

// A(angle, slide): turns by `angle` about the line and slides by `slide` along it.
Eigen::Isometry3d displacement(const Screw& screw, double angle, double slide = 0.0);

// The closure equation A1 A2 ... An of a chain whose screws are given in its zero pose, base first. Precondition: as many angles.
Eigen::Isometry3d closure(std::span<const Screw> screws, std::span<const double> angles);

}  // namespace foothold::kinematics
