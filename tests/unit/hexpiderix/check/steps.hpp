// Sound steps on a slope, to be spoilt.
#pragma once

#include "../planning.hpp"
#include "hexpiderix/check/check.hpp"

namespace foothold::hexpiderix::testing {

inline constexpr double kSlope = 0.2;  // rad, of the ground, falling towards +x

struct Judged {
  Step step;
  Posture before;
  CheckOptions options{0.0, 100.0, 0.005};
};

inline const Ground& slope() {
  static const Ground ground(terrain::parse_terrain(bent_ground(kSlope, kSlope, 0.0)));
  return ground;
}

inline StepVerdict verdict_of(const Judged& judged) {
  return check_step(shipped_model(), slope().surface(), judged.step, judged.before, judged.options);
}

inline std::vector<Judged> planned(const Request& request, const std::map<std::string, std::string>& set) {
  const Parameters values = parameters(set);
  Posture before = shared_planner().start(request, values, slope());
  Collector out;
  shared_planner().plan(request, values, slope(), out);
  std::vector<Judged> steps;
  for (const Step& step : out.steps) {
    steps.push_back({step, before});
    before = step.after;
  }
  return steps;
}

// From the standing triad to the best posture.
inline Judged adapted() { return planned(request_at({0.1, 0, 0}), {}).at(0); }
// Half cycles of a walk up the slope.
inline std::vector<Judged> walked() { return planned(walk_between(on(slope(), 0.3, 0), on(slope(), 0, 0.1)), {}); }
// A fourth leg comes down.
inline Judged joined() { return planned(request_at({0.1, 0, 0}), {{"method", "emergency"}}).at(0); }

}  // namespace foothold::hexpiderix::testing
