// Judges whether a step keeps clear of the obstacles, by samples of its motion so dense that nothing fits between two of them.
// Bodies are polygons in the world here; the search measures boxes in the frame of the body that holds (surroundings.hpp).
#pragma once

#include "body.hpp"
#include "chain.hpp"
#include "geometry/plane_scene.hpp"

namespace foothold::xrobin {

struct Clearance {
  double least = 0.0;    // m, of bodies and pistons over the whole step; infinite without obstacles near
  std::string obstacle;  // the nearest
};

// Between two samples no corner and no pin moves by more than this (m).
inline constexpr double kSampleStep = 1e-3;

// The step must have been found sound by check_step().
Clearance least_clearance(const Lengths& lengths, const Bodies& bodies, const std::vector<geometry::Obstacle>& obstacles,
                          const Step& step, const Posture& before);

}  // namespace foothold::xrobin
