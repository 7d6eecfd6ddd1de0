#include "hyrecro/paper/face_walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace foothold::hyrecro {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

PlanarPose planar(const Foothold& foothold) { return {foothold.at.x(), foothold.at.y(), foothold.heading}; }

// The place and heading of a grid pose of the workspace, the foot that holds standing at `current`.
Foothold placed(const WorkspaceOrder& order, const Foothold& current, const PlanarWorkspace::Cell& cell, int heading) {
  const Vector2d at = current.at + Eigen::Rotation2Dd(current.heading) * order.position(cell);
  return {current.face, at, std::remainder(current.heading + heading * order.workspace().heading_step(), kTurn)};
}

// The foothold if the plate lies on the face and the conservative solution is free of the scene.
std::optional<Stride> admitted(const Walker& w, const Foothold& current, const PlanarWorkspace::Cell& cell, int heading) {
  const Foothold to = placed(w.order, current, cell, heading);
  if (!plate_on_face(w.model, w.scene.truss.faces[static_cast<std::size_t>(to.face)], to)) return std::nullopt;
  const Coordinates coordinates = w.order.workspace().conservative(cell.i, cell.j, heading);
  if (!w.solutions.admits(pose_of(w.scene.truss, current), coordinates)) return std::nullopt;
  return Stride{to, coordinates};
}

// Reachable headings of a cell in the order of their distance from `wanted` (rad, seen from the foot that holds), until `take` is
// true.
template <class Take>
bool headings_from(const PlanarWorkspace& workspace, const PlanarWorkspace::Cell& cell, double wanted, const Take& take) {
  const int count = workspace.headings();
  const double steps = wanted / workspace.heading_step();
  const int middle = static_cast<int>(std::lround(steps));
  const int side = steps >= middle ? 1 : -1;
  for (int n = 0; n < count; ++n) {
    const int offset = (n % 2 == 1 ? side : -side) * ((n + 1) / 2);
    const int heading = ((middle + offset) % count + count) % count;
    if (workspace.reachable(cell.i, cell.j, heading) && take(heading)) return true;
  }
  return false;
}

// The destination itself, if the free foot gets there from `current`.
std::optional<Stride> to_destination(const Walker& w, const Foothold& current, const Foothold& to) {
  const PlanarWorkspace& workspace = w.order.workspace();
  if ((to.at - current.at).norm() > (workspace.extent() + 1) * workspace.position_step()) return std::nullopt;
  const Isometry3d holding = pose_of(w.scene.truss, current), free = pose_of(w.scene.truss, to);
  const Answer answer = w.solutions.solve(holding, free);
  if (!answer.reachable) return std::nullopt;
  return Stride{to, answer.coordinates ? *answer.coordinates : w.solutions.nearest(holding.inverse() * free)};
}

// Whether the workspace's grid pose nearest to `to` is reachable from `current`.
bool on_grid(const PlanarWorkspace& workspace, const Foothold& current, const Foothold& to) {
  const PlanarPose seen = seen_from(planar(current), planar(to));
  const int i = static_cast<int>(std::lround(seen.x / workspace.position_step()));
  const int j = static_cast<int>(std::lround(seen.y / workspace.position_step()));
  if (std::max(std::abs(i), std::abs(j)) > workspace.extent()) return false;
  const int count = workspace.headings();
  const int k = static_cast<int>(std::lround(seen.heading / workspace.heading_step()));
  return workspace.reachable(i, j, (k % count + count) % count);
}

// The additional foothold, from which the destination is reached: as near as can be to the circle of r_opt round it, heading there.
std::optional<std::array<Stride, 2>> by_optimal_circle(const Walker& w, const SafeGround& ground, const Foothold& current,
                                                       const Foothold& to, const std::stop_token& stop) {
  const PlanarWorkspace& workspace = w.order.workspace();
  struct Candidate {
    double off;  // m, from the circle
    const PlanarWorkspace::Cell* cell;
  };
  std::vector<Candidate> candidates;
  for (const PlanarWorkspace::Cell& cell : workspace.cells()) {
    const Vector2d at = placed(w.order, current, cell, 0).at;
    if (ground.holds(at)) candidates.push_back({std::fabs((at - to.at).norm() - workspace.r_opt()), &cell});
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.off < b.off; });
  std::optional<std::array<Stride, 2>> found;
  for (const Candidate& candidate : candidates) {
    if (stop.stop_requested()) break;
    const Vector2d ahead = to.at - placed(w.order, current, *candidate.cell, 0).at;
    const double wanted = std::atan2(ahead.y(), ahead.x()) - current.heading;
    const bool taken = headings_from(workspace, *candidate.cell, wanted, [&](int heading) {
      if (!on_grid(workspace, placed(w.order, current, *candidate.cell, heading), to)) return false;
      const std::optional<Stride> additional = admitted(w, current, *candidate.cell, heading);
      if (!additional) return false;
      const std::optional<Stride> last = to_destination(w, additional->to, to);
      if (last) found = {*additional, *last};
      return last.has_value();
    });
    if (taken) break;
  }
  return found;
}

std::string in_words(const Walker& w, const Foothold& foothold) {
  char text[160];
  std::snprintf(text, sizeof text, "(%.3f, %.3f) m, heading %.0f deg, on face ", foothold.at.x(), foothold.at.y(),
                foothold.heading * 360.0 / kTurn);
  return text + w.scene.truss.faces[static_cast<std::size_t>(foothold.face)].name;
}

}  // namespace

std::optional<Stride> next_best_foothold(const Walker& w, const SafeGround& ground, const std::vector<Vector2d>& way,
                                         const Foothold& current, double reach) {
  const PlanarWorkspace& workspace = w.order.workspace();
  const Vector2d best = crossing(way, current.at, reach);
  const Vector2d best_seen = Eigen::Rotation2Dd(-current.heading) * (best - current.at);
  std::optional<Stride> found;
  w.order.nearest_first(best_seen, [&](const PlanarWorkspace::Cell& cell) {
    const Vector2d at = placed(w.order, current, cell, 0).at;
    if (!ground.holds(at)) return false;
    if (w.options.rule == FaceRule::kZhu)
      return headings_from(workspace, cell, 0.0, [&](int heading) {
        found = admitted(w, current, cell, heading);
        return found.has_value();
      });
    Vector2d ahead = crossing(way, at, reach) - at;
    // On the way's end itself: along its last part.
    if (ahead.norm() < geometry::kOnBoundary) ahead = way.back() - way[way.size() - 2];
    const double wanted = std::atan2(ahead.y(), ahead.x()) - current.heading;
    headings_from(workspace, cell, wanted, [&](int heading) {
      // Only the nearest heading is a candidate: u_cand.
      if (std::cos(heading * workspace.heading_step() - wanted) >= w.options.least_dot) found = admitted(w, current, cell, heading);
      return true;
    });
    return found.has_value();
  });
  return found;
}

FaceWalk walk_face(const Walker& w, const SafeGround& ground, const Foothold& from, const Foothold& to,
                   const std::stop_token& stop) {
  FaceWalk walk;
  const auto arrived = [&](const Foothold& current) {
    const std::optional<Stride> last = to_destination(w, current, to);
    if (!last) return false;
    walk.strides.push_back(*last);
    walk.outcome = FaceWalk::Outcome::kReached;
    return true;
  };
  if (arrived(from)) return walk;
  if (ground.empty()) {
    walk.stuck = "the face is too narrow: no place keeps its distance from all edges";
    return walk;
  }
  walk.way = ground.way(from.at, to.at, w.options.way);
  if (walk.way.empty()) {
    walk.stuck = "no continuous way leads from " + in_words(w, from) + " to " + in_words(w, to) + " inside the safe polygon";
    return walk;
  }
  const PlanarWorkspace& workspace = w.order.workspace();
  const double r_max = w.options.r_max > 0.0 ? w.options.r_max : workspace.r_max();
  const double rounds = 8.0 + 2.0 * geometry::length_of(walk.way) / workspace.r_opt();
  Foothold current = from;
  while (static_cast<double>(walk.strides.size()) < rounds) {
    if (stop.stop_requested()) {
      walk.outcome = FaceWalk::Outcome::kStopped;
      return walk;
    }
    const double d = (to.at - current.at).norm();
    const double r = std::min(r_max, d - workspace.r_opt());
    if (r < w.order.least_reach()) {
      if (const auto two = by_optimal_circle(w, ground, current, to, stop)) {
        walk.strides.insert(walk.strides.end(), two->begin(), two->end());
        walk.outcome = FaceWalk::Outcome::kReached;
        return walk;
      }
      if (stop.stop_requested()) {
        walk.outcome = FaceWalk::Outcome::kStopped;
        return walk;
      }
      walk.stuck = "from " + in_words(w, current) + " no additional foothold leads to " + in_words(w, to);
      return walk;
    }
    const std::optional<Stride> next = next_best_foothold(w, ground, walk.way, current, r);
    if (!next) {
      walk.stuck = "from " + in_words(w, current) + " no foothold along the way is free and well turned";
      return walk;
    }
    walk.strides.push_back(*next);
    current = next->to;
    if (arrived(current)) return walk;
  }
  walk.stuck = "the walk does not come nearer to " + in_words(w, to) + " than " + in_words(w, current);
  return walk;
}

}  // namespace foothold::hyrecro
