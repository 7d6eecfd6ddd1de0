#include "hyrecro/motion/rise.hpp"

#include <algorithm>

#include "hyrecro/motion/lift.hpp"
#include "hyrecro/motion/solutions.hpp"
#include "hyrecro/reach/inverse.hpp"
#include "hyrecro/reach/reachability.hpp"

namespace foothold::hyrecro {
namespace {

constexpr SolutionGrid kGrid{0.1, 0.01, 0.1};
// Ways up that are judged before a stance is given up.
constexpr int kMostJudged = 24;

Blocked judge(const Surroundings& around, const std::vector<Coordinates>& way) {
  std::vector<Actuators> points{to_actuators(around.model, way.front())};
  for (std::size_t i = 1; i < way.size(); ++i)
    points.push_back(with_nearest_turns(points.back(), to_actuators(around.model, way[i])));
  return judge_way(around, points);
}

// Postures of the stance's branch with its free sole `height` above its place, nearest first (by the actuators' time).
std::vector<Coordinates> nearest_first(const Model& model, const Coordinates& stance, double height, const SolutionGrid& grid) {
  const Actuators at = to_actuators(model, stance);
  const Isometry3d above = forward(model, stance) * Eigen::Translation3d(0.0, 0.0, height);
  std::vector<Coordinates> out = solutions(model, above, grid, &stance);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < out.size(); ++i)
    order.emplace_back(duration(model, at, with_nearest_turns(at, to_actuators(model, out[i]))), i);
  std::sort(order.begin(), order.end());
  std::vector<Coordinates> sorted;
  sorted.reserve(out.size());
  for (const auto& [time, i] : order) sorted.push_back(out[i]);
  return sorted;
}

}  // namespace

std::optional<std::vector<Coordinates>> rise(const Surroundings& around, const Coordinates& stance, const MotionOptions& options,
                                             bool whole, std::string& reason) {
  const double height = kLiftFactor * options.lift;
  if (const auto line = lift(around.model, stance, height, options.line_tolerance)) {
    const Blocked blocked = judge(around, *line);
    if (!blocked) return line;
    reason = "while the foot is lifted " + blocked.what;
  } else {
    reason = "the leg has no room to lift its foot";
  }
  if (!whole) return std::nullopt;
  std::optional<std::vector<Coordinates>> found;
  int judged = 0;
  const auto leads_up = [&](const Coordinates& top) {
    if (judged == kMostJudged || around.stop.stop_requested()) return false;
    found = slide(around.model, stance, top, height, options.line_tolerance);
    if (found && judge(around, *found)) {
      found.reset();
      ++judged;
    }
    return found.has_value();
  };
  for (const Coordinates& top : nearest_first(around.model, stance, height, kGrid))
    if (leads_up(top)) return found;
  // What is left above may be too little for a grid.
  const Branch branch = branch_of(stance);
  const Isometry3d above = forward(around.model, stance) * Eigen::Translation3d(0.0, 0.0, height);
  const bool any_s1 = singular(above);
  const auto admit = [&](const Coordinates& top) {
    const Branch of = branch_of(top);
    return of.s2 == branch.s2 && (any_s1 || of.s1 == branch.s1) && leads_up(top);
  };
  if (make_exact(around.model, around.clearance)->reach(above, admit).reachable && found) return found;
  reason += ", nor has the whole robot";
  return std::nullopt;
}

}  // namespace foothold::hyrecro
