// A robot that stands: coordinates of a foot's view to the interface's postures and back, and where a foot hangs that holds on
// nothing.
#pragma once

#include <optional>

#include "hyrecro/scene/prepared.hpp"

namespace foothold::hyrecro {

// The base of a posture: the hip plate, X from A's hip axis to B's, Z along the axes. `first`: the foot that `coordinates` look
// from; `sole`: its world pose. Any thread.
Isometry3d base_of(const Model& model, const Coordinates& coordinates, Foot first, const Isometry3d& sole);

// `base` and `joints` without the stance. Any thread.
Posture posture_of(const Model& model, const Coordinates& coordinates, Foot first, const Isometry3d& sole);

// The world pose of foot A's sole and the coordinates that look from it. Precondition: ten joints within the limits by 1e-6 m.
struct Stand {
  Coordinates coordinates;
  Isometry3d sole;
};
Stand stand_of(const Model& model, const Posture& posture);

// True if the bodies keep the scene's clearance from each other and from the truss.
bool is_free(const Model& model, const PreparedTruss& scene, const Coordinates& coordinates, const Isometry3d& sole);

// A posture in which one foot holds at `sole` and the other is in the air, free of collisions: the first such of a fixed list that
// begins with the hip upright over the foot and the other leg drawn up. Empty if none of them is free.
std::optional<Coordinates> hanging(const Model& model, const PreparedTruss& scene, const Isometry3d& sole);

}  // namespace foothold::hyrecro
