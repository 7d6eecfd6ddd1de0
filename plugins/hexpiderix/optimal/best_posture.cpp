// Best-first branch and bound over boxes of grid poses, then a pattern search between them.
#include "hexpiderix/optimal/best_posture.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "hexpiderix/optimal/pose_bound.hpp"
#include "hexpiderix/optimal/support_frame.hpp"

namespace foothold::hexpiderix {
namespace {

using Index = std::array<int, 6>;

// Grid poses between two corners, both included.
struct Box {
  Index low, high;
  double bound;
  bool is_leaf() const { return low == high; }
  bool operator<(const Box& other) const { return bound < other.bound; }
};

class Search {
 public:
  Search(const Model& model, const Situation& from, const BestOptions& options)
      : model_(model),
        from_(from),
        options_(options),
        ranges_{options.grid.along, options.grid.across, options.grid.height,
                options.grid.roll,  options.grid.pitch,  options.grid.yaw},
        bound_(model, from.ground, from.footholds, support_frame(from), from.clearance),
        equilibrium_(contact::FrictionCone::circular()) {}

  BestPosture run(const std::stop_token& stop) {
    Box all{{}, {}, 0.0};
    for (std::size_t k = 0; k < 6; ++k) all.high[k] = ranges_[k].count() - 1;
    consider(all);
    while (!open_.empty() && open_.top().bound > out_.on_grid.nesm) {
      constexpr long kBetweenLooks = 64;
      if (out_.boxes % kBetweenLooks < 2 && stop.stop_requested()) return ended(BestPosture::End::kStopped);
      if (out_.boxes >= options_.most_boxes) return ended(BestPosture::End::kExhausted);
      const Box box = open_.top();
      open_.pop();
      split(box);
    }
    return ended(out_.on_grid.valid() ? BestPosture::End::kProved : BestPosture::End::kNone);
  }

 private:
  // Bounds a box; keeps it if it can hold a better pose.
  void consider(Box box) {
    ++out_.boxes;
    PoseVector middle{}, half{};
    for (std::size_t k = 0; k < 6; ++k) {
      middle[k] = 0.5 * (ranges_[k].at(box.low[k]) + ranges_[k].at(box.high[k]));
      half[k] = 0.5 * (box.high[k] - box.low[k]) * ranges_[k].step;
    }
    const auto bound = bound_(middle, half);
    if (!bound || *bound <= out_.on_grid.nesm) return;
    if (box.is_leaf()) {
      const Evaluation found = judge(middle);
      if (found.valid() && found.nesm > out_.on_grid.nesm) {
        out_.on_grid = found;
        best_ = middle;
      }
      return;
    }
    box.bound = *bound;
    open_.push(box);
  }

  void split(const Box& box) {
    constexpr double kArm = 0.3;  // m: a turn counts as much as the feet's way seen from the thorax
    std::size_t widest = 0;
    double most = -1.0;
    for (std::size_t k = 0; k < 6; ++k) {
      const double width = (box.high[k] - box.low[k]) * ranges_[k].step * (k < 3 ? 1.0 : kArm);
      if (width <= most) continue;
      most = width;
      widest = k;
    }
    Box lower = box, upper = box;
    lower.high[widest] = (box.low[widest] + box.high[widest]) / 2;
    upper.low[widest] = lower.high[widest] + 1;
    consider(lower);
    consider(upper);
  }

  Evaluation judge(const PoseVector& at) {
    ++out_.evaluated;
    Evaluation found = evaluate(model_, from_.ground, from_.footholds, bound_.pose(at), {model_.lift, true}, from_.clearance);
    if (found.valid() && found.nesm > std::max(0.0, out_.on_grid.nesm) && std::isfinite(options_.friction) &&
        !stands(equilibrium_, from_.footholds, found.centre_of_mass, options_.friction))
      found.fault = Evaluation::Fault::kSlides;
    return found;
  }

  BestPosture ended(BestPosture::End end) {
    out_.end = end;
    out_.polished = out_.on_grid;
    if (out_.on_grid.valid()) polish();
    return out_;
  }

  // Uphill from the grid's best, along one coordinate at a time, with steps that halve.
  void polish() {
    constexpr double kLeast = 1.0 / 256;  // of the grid's step
    for (double scale = 0.5; scale >= kLeast;) {
      bool better = false;
      for (std::size_t k = 0; k < 6; ++k)
        for (const double sign : {1.0, -1.0}) {
          if (ranges_[k].count() == 1) continue;
          PoseVector next = best_;
          next[k] = std::clamp(best_[k] + sign * scale * ranges_[k].step, ranges_[k].low, ranges_[k].at(ranges_[k].count() - 1));
          const Evaluation found = judge(next);
          if (!found.valid() || found.nesm <= out_.polished.nesm) continue;
          out_.polished = found;
          best_ = next;
          better = true;
        }
      if (!better) scale *= 0.5;
    }
  }

  const Model& model_;
  const Situation& from_;
  const BestOptions& options_;
  const std::array<PoseGrid::Range, 6> ranges_;
  const PoseBound bound_;
  contact::Equilibrium equilibrium_;
  std::priority_queue<Box> open_;
  PoseVector best_{};
  BestPosture out_;
};

}  // namespace

int PoseGrid::Range::count() const { return std::max(1, static_cast<int>(std::floor((high - low) / step + 1e-9)) + 1); }

BestPosture best_posture(const Model& model, const Situation& from, const BestOptions& options, const std::stop_token& stop) {
  return Search(model, from, options).run(stop);
}

}  // namespace foothold::hexpiderix
