// Is the straight way between two postures free of collisions? Proved for every posture on it, not sampled.
#pragma once

#include <span>
#include <stop_token>
#include <string>

#include "hyrecro/model/bodies.hpp"
#include "hyrecro/motion/actuators.hpp"

namespace foothold::hyrecro {

// Where a motion happens. Borrows model and obstacles. Used by one thread at a time.
struct Surroundings {
  const Model& model;
  const Obstacles& obstacles;
  Isometry3d holding;      // world pose of the sole that holds
  double clearance = 0.0;  // m, of legs and hip from solids, and of the robot's bodies from each other
  std::stop_token stop;
  mutable long judged = 0;  // postures whose distances were computed
};

// What is in the way.
struct Blocked {
  std::string what;  // for people; empty: the way is free
  explicit operator bool() const { return !what.empty(); }
};

// Conservative advancement: at a posture in the middle of a part of the way, distances less sweep() tell how far to both sides it
// is proved free; what is left over is judged in the same manner, coarse parts first. Legs and hip keep `clearance` from solids,
// the free plate does not touch any (the plate that holds does not move and is not judged), the robot's bodies keep `clearance`
// from each other. Not judged: limits (the straight way between postures within the limits keeps them). A way of several pieces is
// straight between its points; all pieces are judged coarsely before any is judged finely, so that most blocked ways cost little.
Blocked judge_way(const Surroundings& around, std::span<const Actuators> way);
Blocked judge_way(const Surroundings& around, const Actuators& a, const Actuators& b);
// The same for a single posture.
Blocked judge_posture(const Surroundings& around, const Coordinates& coordinates);

}  // namespace foothold::hyrecro
