#include "hyrecro/route/unreachable.hpp"

#include <algorithm>
#include <cstdio>

namespace foothold::hyrecro {
namespace {

constexpr std::size_t kMostPairs = 50;

struct Pair {
  double distance;  // m
  Foothold from, to;
};

std::string place(const PreparedTruss& scene, const Foothold& foothold) {
  char text[64];
  std::snprintf(text, sizeof text, " (%.3f, %.3f)", foothold.at.x(), foothold.at.y());
  return scene.truss.faces[static_cast<std::size_t>(foothold.face)].name + text;
}

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f m", value);
  return text;
}

std::vector<Pair> nearest_pairs(const PreparedTruss& scene, std::span<const Foothold> reached, const Foothold& goal) {
  std::vector<Foothold> entries{goal};
  for (const int k : scene.transitions.of_face(goal.face))
    entries.push_back(scene.transitions.all()[static_cast<std::size_t>(k)].foothold);
  std::vector<Pair> pairs;
  for (const Foothold& to : entries) {
    const Vector3d there = pose_of(scene.truss, to).translation();
    for (const Foothold& from : reached)
      if (from.face != goal.face) pairs.push_back({(pose_of(scene.truss, from).translation() - there).norm(), from, to});
  }
  const std::size_t kept = std::min(kMostPairs, pairs.size());
  const auto nearer = [](const Pair& a, const Pair& b) { return a.distance < b.distance; };
  std::partial_sort(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(kept), pairs.end(), nearer);
  pairs.resize(kept);
  return pairs;
}

// What the posture meets: the body and the solid that are nearest to each other.
std::string meets(const PreparedTruss& scene, const Bodies& bodies) {
  const Obstacles::Nearest limb = scene.obstacles.nearest(bodies, 1.0), plate = scene.obstacles.nearest_of_plates(bodies, 1.0);
  const bool by_plate = limb.solid < 0 || (limb.distance >= scene.clearance && plate.solid >= 0);
  const Obstacles::Nearest& what = by_plate ? plate : limb;
  if (what.solid < 0) return "the scene";
  return what.body + " comes within " + metres(what.distance) + " of " +
         scene.truss.solids[static_cast<std::size_t>(what.solid)].name + " (clearance " + metres(scene.clearance) + ")";
}

}  // namespace

Failure explain_unreachable(const Model& model, const PreparedTruss& scene, Reachability& exact, std::span<const Foothold> reached,
                            const Foothold& goal, double greatest_reach) {
  Failure failure{PlanError::kUnreachableGoal, "goal", {}, {}};
  const std::string face = scene.truss.faces[static_cast<std::size_t>(goal.face)].name;
  if (scene.transitions.all().empty()) {
    failure.message = "face " + face + " cannot be entered: the scene has no transition footholds between any two faces";
    failure.hint = "faces must share an edge or meet at a corner, and be wide enough for the gripper's plate";
    return failure;
  }
  const std::vector<Pair> pairs = nearest_pairs(scene, reached, goal);
  failure.message = "face " + face + " cannot be entered: ";
  if (pairs.empty() || pairs.front().distance > greatest_reach) {
    failure.message +=
        pairs.empty()
            ? "nothing else can be reached"
            : "its nearest transition is " + metres(pairs.front().distance) + " from " + place(scene, pairs.front().from) +
                  ", the nearest foothold that can be reached; soles are at most " + metres(greatest_reach) + " apart";
    failure.hint = "another beam in between, or a smaller sampling step, may make a way";
    return failure;
  }
  for (const Pair& pair : pairs) {
    if (pair.distance > greatest_reach) break;
    const Isometry3d holding = pose_of(scene.truss, pair.from);
    const Reach alone = exact.reach(holding.inverse() * pose_of(scene.truss, pair.to), {});
    if (!alone.reachable) continue;
    failure.message += "its nearest transition that the robot spans, from " + place(scene, pair.from) + " to " +
                       place(scene, pair.to) + ", is blocked: " + meets(scene, bodies_at(model, *alone.coordinates, holding));
    failure.hint = "a smaller clearance, or a smaller sampling step, may make a way";
    return failure;
  }
  failure.message += "no posture within the actuators' limits spans its nearest transition, from " +
                     place(scene, pairs.front().from) + " to " + place(scene, pairs.front().to) + ", " +
                     metres(pairs.front().distance) + " apart";
  failure.hint = "a smaller sampling step, or other distances from the edges, may make a way";
  return failure;
}

}  // namespace foothold::hyrecro
