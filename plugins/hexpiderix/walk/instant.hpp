// One instant of a walk: thorax, feet on the ground and feet in the air; and whether all is well. Any thread.
#pragma once

#include "contact/equilibrium.hpp"
#include "hexpiderix/walk/walk.hpp"

namespace foothold::hexpiderix {

// Joints that bring all six feet to `feet` (m, world); false with the leg that does not reach.
bool place_feet(const Model& model, const Isometry3d& thorax, const std::array<Vector3d, kLegs>& feet, Coordinates& at,
                std::size_t& leg);

// NESM on the supporting legs alone; `com` gets the centre of mass.
double nesm_on(const Model& model, const Coordinates& at, const Footholds& feet, Legs supports, Vector3d& com);

// The name of the first body that is nearer than the clearance to the ground or to another; empty if all is clear. Toes are not
// judged against the ground.
std::string in_the_way(const Model& model, const terrain::Surface& surface, const Coordinates& at, double clearance);

}  // namespace foothold::hexpiderix
