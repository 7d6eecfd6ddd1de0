// What the motions' tests share: the shipped robot, stances on faces, and a judge of motions that samples them densely.
#pragma once

#include <optional>
#include <random>
#include <string>

#include "hyrecro/motion/motion.hpp"

namespace foothold::hyrecro::testing {

const Model& shipped_model();
// A solid slab whose upper face is the plane z = 0, 4 m by 4 m.
truss::Truss plane();
// With a plate of `thickness` (m) that stands upright across the X axis at x = `at`, from `begin` to `end` along Y, `height` high.
truss::Truss plane_with_plate(double at, double begin, double end, double height, double thickness);

double uniform(std::mt19937_64& random, double low, double high);
// Coordinates of a random stance whose free sole stands on the plane of the one that holds, at least 0.15 m away, bodies
// `clearance` from each other and from the slab.
Coordinates random_stance(const Obstacles& obstacles, std::mt19937_64& random, double clearance);
// The same, both soles where they are in `stance`, other joints.
std::optional<Coordinates> random_solution(const Obstacles& obstacles, const Isometry3d& holding, const Isometry3d& free_in_holding,
                                           std::mt19937_64& random, double clearance);

// Samples a motion by linear interpolation of the joints, `samples` of them, and judges each by forward kinematics: limits,
// collisions, the first and the last metres along the normal, speeds, first and last posture. Empty if there is nothing to say.
std::string fault_of(const Obstacles& obstacles, const Isometry3d& holding, const Coordinates& from, const Coordinates& to,
                     bool free_lifts, const MotionOptions& options, const Motion& motion, int samples);

}  // namespace foothold::hyrecro::testing
