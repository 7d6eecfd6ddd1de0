// The steps of standing up (section 5.1), for whoever stands otherwise than over a node: the paper's method, and stops on the way
// from posture to posture.
#pragma once

#include "octopod/posture/pair.hpp"
#include "octopod/posture/posture.hpp"
#include "terrain/surface.hpp"

namespace foothold::octopod {

// C at its height above the node; each body's Z the normal of the ground triangle beneath C +- L ep (straight down; where none lies
// there, the nearest one), its X the axis projected into its plane. Empty if there is no ground at all.
std::optional<Pair> bodies_over(const Model& model, const terrain::Surface& surface, const Vector3d& node, const Vector3d& normal,
                                int orientation);

// Where the foot of a leg with a right angle hangs, m, world.
Vector3d foot_in_the_air(const Model& model, const Pair& pair, int leg);

// Of a robot whose coordinates and feet are there: rear module, centre of mass, residual; whether bodies or legs touch the ground
// or the bodies each other; and, with `legs_too`, whether legs touch each other or a body.
Hindrance complete(const Model& model, const terrain::Surface& surface, double clearance, bool legs_too, Built& built);

// All of stand() once the bodies are placed.
Built stand_with(const Model& model, const terrain::Surface& surface, Pair pair, double clearance);

}  // namespace foothold::octopod
