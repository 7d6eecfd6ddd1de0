// A second judge for steps on a floor, by dense samples and none of the first one's code: its own kinematics (bisection for the
// mechanisms, the paper's frames), every body with every solid, points along the plate's edge.
#pragma once

#include <string>

#include "walk.hpp"

namespace foothold::hyrecro {

// What is still right: with `sharp` everything must keep a little more than the first judge demands, without it only what that
// judge promises to have proved.
struct Allowance {
  bool sharp = false;
  int samples = 40;  // of each piece of the motion
};

// The first wrong found, in words; empty: none.
std::string densely_judged(const Model& model, const truss::Truss& truss, const CheckOptions& options, const Walk& walk, Foot holds,
                           const Allowance& allowance);

// The pose of the other sole and of the base, seen from the sole of the foot that holds.
struct Chain {
  std::array<Isometry3d, 2> sole;
  Isometry3d base;
  Bodies bodies;
};
Chain chain_by_the_paper(const Model& model, const std::vector<double>& joints, Foot holds);

}  // namespace foothold::hyrecro
