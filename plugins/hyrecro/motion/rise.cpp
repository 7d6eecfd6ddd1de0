#include "hyrecro/motion/rise.hpp"

#include <algorithm>

#include "hyrecro/motion/lift.hpp"
#include "hyrecro/motion/solutions.hpp"

namespace foothold::hyrecro {
namespace {

constexpr SolutionGrid kGrid{0.1, 0.01, 0.1};
// Shifts that are judged before a stance is given up.
constexpr std::size_t kMostShifts = 24;

Blocked judge(const Surroundings& around, const std::vector<Coordinates>& way) {
  Blocked out;
  Actuators last = to_actuators(around.model, way.front());
  for (std::size_t i = 1; i < way.size() && !out; ++i) {
    const Actuators next = with_nearest_turns(last, to_actuators(around.model, way[i]));
    out = judge_way(around, last, next);
    last = next;
  }
  return out;
}

}  // namespace

std::optional<std::vector<Coordinates>> rise(const Surroundings& around, const Coordinates& stance, const MotionOptions& options,
                                             bool shifts, std::string& reason) {
  const double height = kLiftFactor * options.lift;
  if (const auto line = lift(around.model, stance, height, options.line_tolerance)) {
    const Blocked blocked = judge(around, *line);
    if (!blocked) return line;
    reason = "while the foot is lifted " + blocked.what;
  } else {
    reason = "the leg has no room to lift its foot";
  }
  if (!shifts) return std::nullopt;
  const Actuators at = to_actuators(around.model, stance);
  std::vector<std::pair<double, Coordinates>> others;
  for (const Coordinates& other : solutions(around.model, forward(around.model, stance), kGrid, &stance))
    if (lifted(around.model, other, height))
      others.emplace_back(duration(around.model, at, with_nearest_turns(at, to_actuators(around.model, other))), other);
  std::stable_sort(others.begin(), others.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::size_t judged = 0;
  for (const auto& [time, other] : others) {
    if (judged == kMostShifts || around.stop.stop_requested()) break;
    const auto way = shift(around.model, stance, other, options.line_tolerance);
    const auto line = way ? lift(around.model, other, height, options.line_tolerance) : std::nullopt;
    if (!line) continue;
    ++judged;
    std::vector<Coordinates> out = *way;
    out.insert(out.end(), line->begin() + 1, line->end());
    const Blocked blocked = judge(around, out);
    if (!blocked) return out;
  }
  reason += ", nor from another posture on the same footholds";
  return std::nullopt;
}

}  // namespace foothold::hyrecro
