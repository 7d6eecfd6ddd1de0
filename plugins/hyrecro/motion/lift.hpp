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
// Whether each leg alone can lift its own foot by `height` (m) while the other foot holds.
bool legs_lift(const Model& model, const Coordinates& stance, double height);
// The greatest height up to `most` (m) that lifted() gives.
double room_to_lift(const Model& model, const Coordinates& stance, double most);

// From `stance` to lifted(stance, height): as many postures that the straight ways between them keep within `tolerance` (m and rad)
// of the line and of the heading. First is the stance. Empty if leg 1 has no room.
std::optional<std::vector<Coordinates>> lift(const Model& model, const Coordinates& stance, double height, double tolerance);

// From `from` to `to`, whose free sole stands `height` (m, 0 or more) above that of `from` in the same orientation: it rises along
// the normal while the free variables of the inverse kinematics go straight from those of `from` to those of `to`; so hip and both
// legs move. Empty if limits or the closed form (both must be of one branch) end on the way. The straight ways between the postures
// keep the free sole within `tolerance` (m and rad) of that line, and if `height` is 0 of its place.
std::optional<std::vector<Coordinates>> slide(const Model& model, const Coordinates& from, const Coordinates& to, double height,
                                              double tolerance);

}  // namespace foothold::hyrecro
