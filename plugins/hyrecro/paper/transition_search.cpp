#include "hyrecro/paper/transition_search.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include "hyrecro/reach/inverse.hpp"

namespace foothold::hyrecro {
namespace {

struct Node {
  double cost = std::numeric_limits<double>::infinity();
  int before = -1;
  bool closed = false;
  std::optional<Coordinates> coordinates;
};

struct Open {
  double estimate;
  int node;
  bool operator<(const Open& other) const { return estimate != other.estimate ? estimate > other.estimate : node > other.node; }
};

// The graph's nodes by index: transition footholds, then start, then goal.
class Search {
 public:
  Search(const PreparedTruss& scene, JointSolutions& solutions, const Foothold& start, const Foothold& goal, double radius)
      : scene_(scene),
        solutions_(solutions),
        ends_{start, goal},
        poses_{pose_of(scene.truss, start), pose_of(scene.truss, goal)},
        radius_(radius),
        sampled_(static_cast<int>(scene.transitions.all().size())),
        nodes_(scene.transitions.all().size() + 2) {}

  GlobalRoute run(const std::stop_token& stop) {
    GlobalRoute route;
    const int start = sampled_, goal = sampled_ + 1;
    improve(start, -1, 0.0, std::nullopt);
    while (!open_.empty()) {
      const int at = open_.top().node;
      open_.pop();
      if (node(at).closed) continue;
      node(at).closed = true;
      if (at == goal) break;
      ++route.expanded;
      expand(at);
      if (stop.stop_requested()) {
        route.outcome = GlobalRoute::Outcome::kStopped;
        return route;
      }
    }
    if (!node(goal).closed) {
      for (int k = 0; k < sampled_ + 1; ++k)
        if (node(k).closed) route.reached.push_back(foothold(k));
      return route;
    }
    route.outcome = GlobalRoute::Outcome::kReached;
    for (int at = goal; at >= 0; at = node(at).before) {
      const int before = node(at).before;
      std::optional<Coordinates> coordinates = node(at).coordinates;
      if (before >= 0 && foothold(before).face != foothold(at).face && !coordinates)
        coordinates = solutions_.nearest(pose(before).inverse() * pose(at));
      route.waypoints.push_back({foothold(at), coordinates});
    }
    std::reverse(route.waypoints.begin(), route.waypoints.end());
    return route;
  }

 private:
  Node& node(int k) { return nodes_[static_cast<std::size_t>(k)]; }
  const Foothold& foothold(int k) const {
    return k < sampled_ ? scene_.transitions.all()[static_cast<std::size_t>(k)].foothold
                        : ends_[static_cast<std::size_t>(k - sampled_)];
  }
  const Isometry3d& pose(int k) const {
    return k < sampled_ ? scene_.transitions.all()[static_cast<std::size_t>(k)].pose
                        : poses_[static_cast<std::size_t>(k - sampled_)];
  }
  double distance(int a, int b) const { return (pose(a).translation() - pose(b).translation()).norm(); }

  // A way over a third foothold on the same straight line is no better: rounding must not prefer it.
  bool better(int k, double cost) const { return cost < nodes_[static_cast<std::size_t>(k)].cost - 1e-12; }

  void improve(int k, int before, double cost, const std::optional<Coordinates>& coordinates) {
    node(k) = {cost, before, false, coordinates};
    open_.push({cost + distance(k, sampled_ + 1), k});
  }

  void expand(int at) {
    const int face = foothold(at).face, goal = sampled_ + 1;
    const double cost = node(at).cost;
    const auto on_face = [&](int to) {
      if (better(to, cost + distance(at, to))) improve(to, at, cost + distance(at, to), std::nullopt);
    };
    for (const int to : scene_.transitions.of_face(face)) on_face(to);
    if (foothold(goal).face == face) on_face(goal);
    const auto across = [&](int to) {
      // What would not become better need not be asked; this changes no route.
      if (!better(to, cost + distance(at, to)) || !singular(pose(at).inverse() * pose(to))) return;
      const Answer answer = solutions_.solve(pose(at), pose(to));
      if (answer.reachable) improve(to, at, cost + distance(at, to), answer.coordinates);
    };
    for (const int to : scene_.transitions.near(pose(at).translation(), radius_, face)) across(to);
    if (foothold(goal).face != face && distance(at, goal) <= radius_) across(goal);
  }

  const PreparedTruss& scene_;
  JointSolutions& solutions_;
  std::array<Foothold, 2> ends_;
  std::array<Isometry3d, 2> poses_;
  double radius_;
  int sampled_;
  std::vector<Node> nodes_;
  std::priority_queue<Open> open_;
};

}  // namespace

GlobalRoute search_transitions(const PreparedTruss& scene, JointSolutions& solutions, const Foothold& start, const Foothold& goal,
                               double radius, const std::stop_token& stop) {
  return Search(scene, solutions, start, goal, radius).run(stop);
}

double greatest_reach(const Model& model) {
  const double leg = model.ankle_height + 2.0 * model.mechanism.offsets(0.0).high - model.core + model.hip_drop;
  return 2.0 * leg + model.hip_distance;
}

}  // namespace foothold::hyrecro
