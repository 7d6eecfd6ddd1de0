// Hex-piderix' bodies against a plane and against each other.
//
// Legs are capsules round femur and tibia, the thorax a box round its hexagon. A foot is a point: the tibia's end, which a
// supporting leg has on the ground and a swinging one `clearance` above it; hips and knees are balls of the capsules' radius. A
// femur touches the thorax by construction and is not judged against it. Metres. Any thread.
#pragma once

#include "collision/distance.hpp"
#include "hexpiderix/stance/stance.hpp"

namespace foothold::hexpiderix {

// Round the hexagon.
collision::Box thorax_box(const Model& model, const Isometry3d& thorax);

// The first fault that was found, or none.
struct Contacting {
  Evaluation::Fault fault = Evaluation::Fault::kNone;
  std::size_t leg = 0, other = 0;
  double distance = 0.0;  // m, between the surfaces; negative: how deep in the ground
};

// Ground first (legs 1 to 6, thorax), then pairs of legs, then tibiae and thorax.
Contacting nearest_trouble(const Model& model, const Coordinates& at, const Plane& ground, Legs supports, double clearance);

// The pairs of legs and the tibiae with the thorax alone.
Contacting trouble_with_itself(const Model& model, const Coordinates& at, double clearance);

}  // namespace foothold::hexpiderix
