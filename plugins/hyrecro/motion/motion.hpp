// The motion of one stride: ten actuators from one stance to the next, free of collisions over the whole path.
#pragma once

#include <optional>
#include <random>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "hyrecro/scene/prepared.hpp"

namespace foothold::hyrecro {

struct MotionOptions {
  double clearance = 0.005;      // m, of legs and hip; see Obstacles::free
  double lift = 0.02;            // m: as far the free sole leaves and meets its surface along its normal; without turning
  double line_tolerance = 5e-4;  // m and rad: how far it may be off that line between two points
};

// The path is linear in the ten actuators (lengths and hip angles, as to_joints() gives them) between its points.
struct Motion {
  // Looking from the foot that holds; first and last are the stances. Hip angles go on without jumps, so the last ones may differ
  // from those of `to` by whole turns.
  std::vector<Coordinates> points;
  std::vector<double> times;  // s from the begin, by the actuators' greatest speeds
  double clearance = 0.0;     // m, proved over the whole path
};

struct MotionResult {
  std::optional<Motion> motion;
  std::string reason;  // why there is none
};

// `from` and `to` look from the foot that holds at `holding` (world pose of its sole). `free_lifts`: whether the free sole stands
// on a surface in `from` (not so at a start with one foot in the air). No hip joint turns by more than pi / 2 between two points.
// Used by one thread at a time; looks at `stop` every 5 ms.
MotionResult plan_motion(const Model& model, const Obstacles& obstacles, const Isometry3d& holding, const Coordinates& from,
                         const Coordinates& to, bool free_lifts, const MotionOptions& options, std::mt19937_64& random,
                         const std::stop_token& stop);

// The motions of a route's strides, one after the other.
struct RouteMotions {
  Route route;                  // as given; coordinates of the stances changed where motions exist or are shorter with others
  std::vector<Motion> motions;  // of the first strides; of all if `failed` is -1
  int failed = -1;              // the first stride for which none was found: to be banned before one searches again
  std::string reason;           // why not
};

// Chooses the stances' coordinates anew (same footholds, other joints: room to lift, near to each other) and plans the motion of
// every stride. `start`: the posture before the first stride, looking from the foot that holds at `route.start`; it stays as it is.
// `free_lifts` as above, for the first stride. Threads as plan_motion().
RouteMotions plan_motions(const Model& model, const Obstacles& obstacles, const truss::Truss& truss, const Route& route,
                          const Coordinates& start, bool free_lifts, const MotionOptions& options, std::mt19937_64& random,
                          const std::stop_token& stop);

// The points' joints in the order of kJointNames if `holds` holds. Hip angles go on without jumps by 2 pi from row to row and from
// `before`, the last row of the stride before (empty: there is none), and may therefore leave (-pi, pi].
std::vector<std::vector<double>> joint_rows(const Model& model, const Motion& motion, Foot holds, std::span<const double> before);

}  // namespace foothold::hyrecro
