// What Xrobin's bodies occupy: two rectangles and two pistons, seen from above and as solids.
#pragma once

#include <array>
#include <vector>

#include "foothold/types.hpp"
#include "mechanism.hpp"
#include "word.hpp"

namespace foothold::xrobin {

// A rectangle round a body's origin, half extents along its x and y axes, standing on the plane.
struct Block {
  double half_x = 0.0;  // m
  double half_y = 0.0;
  double height = 0.0;
};

struct Bodies {
  Block a;
  Block b;
  double piston_radius = 0.0;  // m

  // Throws InvalidModel if a body does not hold its pins, or body A not its slot.
  static Bodies from_model(const RobotModel& model, const Mechanism& mechanism);
};

// A piston's pins in the world: on body A, on body B.
struct PistonAxis {
  Eigen::Vector2d on_a;
  Eigen::Vector2d on_b;
};

// l, then r.
std::array<PistonAxis, 2> piston_axes(const Lengths& lengths, const BodyPoses& bodies);

// Boxes "A" and "B", capsules "piston l" and "piston r".
std::vector<Shape> solids(const Bodies& bodies, const Lengths& lengths, const BodyPoses& poses);

}  // namespace foothold::xrobin
