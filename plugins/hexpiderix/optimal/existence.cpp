// Whether any posture is stable: boxes of poses, the most promising first, until one pose stands or none is left that could.
#include <algorithm>
#include <cmath>
#include <queue>

#include "hexpiderix/optimal/best_posture.hpp"
#include "hexpiderix/optimal/pose_bound.hpp"
#include "hexpiderix/optimal/support_frame.hpp"

namespace foothold::hexpiderix {
namespace {

struct Region {
  PoseVector middle, half;
  double bound;
  bool operator<(const Region& other) const { return bound < other.bound; }
};

}  // namespace

Existence stable_posture(const Model& model, const Situation& from, const BestOptions& options, const std::stop_token& stop) {
  const std::array<PoseGrid::Range, 6> ranges{options.grid.along, options.grid.across, options.grid.height,
                                              options.grid.roll,  options.grid.pitch,  options.grid.yaw};
  const PoseBound bound(model, from.ground, from.footholds, support_frame(from), from.clearance);
  contact::Equilibrium equilibrium(contact::FrictionCone::circular());
  Existence out;
  std::priority_queue<Region> open;
  const auto consider = [&](Region region) {
    ++out.boxes;
    const auto most = bound(region.middle, region.half);
    if (!most || *most <= 0.0) return;
    region.bound = *most;
    open.push(region);
  };
  Region all{};
  for (std::size_t k = 0; k < 6; ++k) {
    const double high = ranges[k].at(ranges[k].count() - 1);
    all.middle[k] = 0.5 * (ranges[k].low + high);
    all.half[k] = 0.5 * (high - ranges[k].low);
  }
  consider(all);
  while (!open.empty()) {
    if (stop.stop_requested() || out.boxes >= options.most_boxes) return out;
    const Region region = open.top();
    open.pop();
    const Evaluation found =
        evaluate(model, from.ground, from.footholds, bound.pose(region.middle), {model.lift, true}, from.clearance);
    if (found.valid() && found.nesm > 0.0 &&
        (!std::isfinite(options.friction) || stands(equilibrium, from.footholds, found.centre_of_mass, options.friction))) {
      out.answer = Existence::Answer::kFound;
      out.found = found;
      return out;
    }
    constexpr double kArm = 0.3;  // m: a turn counts as much as the feet's way seen from the thorax
    const auto width = [&](std::size_t k) { return region.half[k] * (k < 3 ? 1.0 : kArm); };
    std::size_t widest = 0;
    for (std::size_t k = 1; k < 6; ++k)
      if (width(k) > width(widest)) widest = k;
    for (const double side : {-0.5, 0.5}) {
      Region part = region;
      part.half[widest] = 0.5 * region.half[widest];
      part.middle[widest] += side * region.half[widest];
      consider(part);
    }
  }
  out.answer = Existence::Answer::kProvedNone;
  return out;
}

}  // namespace foothold::hexpiderix
