// The closed chain as a judge sees it: poses and pins in the world, no curves and no tables of the search.
#pragma once

#include <Eigen/Geometry>
#include <sstream>
#include <string>

#include "foothold/types.hpp"
#include "mechanism.hpp"

namespace foothold::xrobin {

// Why a step is refused. Thrown inside the checker only.
struct Refusal {
  std::string reason;
};

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream out;
  out.precision(9);
  (out << ... << parts);
  throw Refusal{out.str()};
}

// Body B in body A's frame, measured, not commanded.
struct Relative {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double turn = 0.0;
};

// The contact of a body, and the body's frame from it: a contact's +X is its body's y axis. Refuses what is missing.
const Contact& limb(const Posture& posture, const char* name);
Isometry3d body(const Isometry3d& contact);

// Refuses bodies that do not lie in one plane.
Relative relative(const Isometry3d& a, const Isometry3d& b);
// How far apart the pins of each piston are.
Pistons measured(const Lengths& lengths, const Relative& b);
// The posture near `guess` with these piston lengths, by Newton's method: it stays on the branch of `guess`.
Relative follow(const Lengths& lengths, Relative guess, double l, double r);

}  // namespace foothold::xrobin
