// Is a posture free of the scene and of itself, as the judge sees it?
//
// Bodies are made thinner by kTouch before they are judged, so that what touches by rounding is no collision. Of the robot with
// itself the pairs of bodies.hpp are judged.
#pragma once

#include <array>
#include <string>

#include "hyrecro/check/check.hpp"

namespace foothold::hyrecro {

inline constexpr double kTouch = 1e-6;  // m
inline constexpr double kLook = 0.5;    // m: so far clearances are looked for

// What a whole step is judged against.
struct Setting {
  const Model& model;
  const truss::Truss& truss;
  const Obstacles& obstacles;
  const CheckOptions& options;
  Foot holds;       // whose bodies come first
  Isometry3d held;  // its sole
};

// The least ones seen so far, m.
struct Clearance {
  double scene = kLook, itself = kLook;
};

// Every side of boxes and the radii of capsules moved in by `by`, m.
Bodies thinner(const Bodies& bodies, double by);

// The pairs of the robot's bodies: distances, and names as "legs A and B".
inline constexpr std::size_t kPairs = 6;
double pair_distance(const Bodies& bodies, std::size_t pair);
bool pair_nearer(const Bodies& bodies, std::size_t pair, double clearance);
std::string pair_name(std::size_t pair, Foot holds);

// Throws Refusal that begins with `where`; lowers `least`. Any thread.
void judge_clear(const Setting& setting, const Coordinates& coordinates, const std::string& where, Clearance& least);

}  // namespace foothold::hyrecro
