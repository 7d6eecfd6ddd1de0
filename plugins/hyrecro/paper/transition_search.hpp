// PPT (section 3.1): A* over transition footholds, start and goal.
#pragma once

#include "hyrecro/paper/joint_solutions.hpp"

namespace foothold::hyrecro {

// A foothold of the global route, and the joint solution if it is entered from another face.
struct Waypoint {
  Foothold foothold;
  std::optional<Coordinates> coordinates;
};

struct GlobalRoute {
  enum class Outcome { kReached, kUnreachable, kStopped };
  Outcome outcome = Outcome::kUnreachable;
  std::vector<Waypoint> waypoints;  // from start to goal, both included
  std::vector<Foothold> reached;    // of kUnreachable: all that can be reached, on every face that can
  std::size_t expanded = 0;
};

// Neighbours of a node: all others on its face, at their straight distance (m); and those on other faces within `radius` (m, by k-d
// tree) that `solutions` reach in a singular posture, the soles' mechanisms parallel: the paper takes no others for transitions
// (section 3.1). Heuristic: the straight distance to the goal.
GlobalRoute search_transitions(const PreparedTruss& scene, JointSolutions& solutions, const Foothold& start, const Foothold& goal,
                               double radius, const std::stop_token& stop);

// The distance between soles that no posture exceeds, m.
double greatest_reach(const Model& model);

}  // namespace foothold::hyrecro
