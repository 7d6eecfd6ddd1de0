// Postures in which the free sole leaves its surface along its normal, in closed form.
#pragma once

#include <optional>
#include <vector>

#include "hyrecro/motion/actuators.hpp"

namespace foothold::hyrecro {

// The sole's normal lies in the plane in which its own leg moves, so the free leg alone lifts it: hip and holding leg stay, psi1
// stays, and the upper pin seen from the sole goes down by `height` (m). Empty if leg 1 has no room for that. What lambda leaves
// free, the split between y1 and y2, stays as near to the middle as it was.
std::optional<Coordinates> lifted(const Model& model, const Coordinates& stance, double height);
// The greatest height up to `most` (m) that lifted() gives.
double room_to_lift(const Model& model, const Coordinates& stance, double most);

// From `stance` to lifted(stance, height): as many postures that the straight ways between them keep within `tolerance` (m and rad)
// of the line and of the heading. First is the stance. Empty if leg 1 has no room.
std::optional<std::vector<Coordinates>> lift(const Model& model, const Coordinates& stance, double height, double tolerance);

// Moves within the postures that have both soles where `from` and `to` have them (same pose, same branch): the free variables
// of the inverse kinematics go straight from those of `from` to those of `to`. Empty if limits or the closed form end on the way.
// The straight ways between the postures keep the free sole within `tolerance` of its place.
std::optional<std::vector<Coordinates>> shift(const Model& model, const Coordinates& from, const Coordinates& to, double tolerance);

// How far the free sole of a posture is from a pose: m, and rad.
struct Deviation {
  double distance = 0.0, angle = 0.0;
  bool within(double tolerance) const { return distance <= tolerance && angle <= tolerance; }
};
Deviation deviation(const Model& model, const Coordinates& coordinates, const Isometry3d& pose);

}  // namespace foothold::hyrecro
