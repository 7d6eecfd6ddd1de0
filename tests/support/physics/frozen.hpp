// The independent judge of balance: a stance frozen into one rigid body and left to gravity in MuJoCo. Does it move?
//
// Every foot is a small sphere that touches a plane of its own, whose normal is the contact's; no foot touches another's plane.
// Contacts take the elliptic cone (the pyramidal one calls unstable stances stable). A stance that can be held with less friction
// than there is stays; one that cannot slides or tips over. MuJoCo's contacts are soft: near the critical friction (about 12 %) it
// may creep.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace foothold::physics {

using Eigen::Vector3d;

struct FrozenContact {
  Vector3d point = Vector3d::Zero();    // m, world
  Vector3d normal = Vector3d::UnitZ();  // unit, out of the surface
};

struct FrozenStance {
  std::vector<FrozenContact> contacts;         // 1 to 31
  Vector3d centre_of_mass = Vector3d::Zero();  // m, world
  double mass = 1.0;                           // kg
  Vector3d inertia = Vector3d::Constant(0.1);  // kg m^2, about world axes
  double friction = 0.0;
};

struct FrozenOptions {
  double duration = 0.6;  // s
  double settling = 0.1;  // s at the beginning that do not count: contacts give way by micrometres until they carry
};

struct Drift {
  double way = 0.0;    // m, greatest way of a foot or the centre of mass after settling
  double speed = 0.0;  // m/s, greatest of those at the end
  // Is still on its way, or came far. A stance at rest may shift a little until all its feet carry.
  bool moves() const { return way > 0.005 || speed > 0.005; }
};

// Throws std::runtime_error with MuJoCo's message. Any thread.
Drift let_go(const FrozenStance& stance, const FrozenOptions& options = {});

}  // namespace foothold::physics
