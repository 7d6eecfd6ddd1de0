// Depth first through the 64 cycles.
#include "brute_force.hpp"

#include <limits>
#include <stdexcept>

namespace foothold::xrobin {
namespace {

// All 64, repeated ends included: the reference must not rest on what the searches merge.
struct Cycle {
  PlanarPose end;
  double cosine, sine;
};

class AllWords {
 public:
  explicit AllWords(const Mechanism& mechanism) {
    for (int first = 1; first <= kConfigurations; ++first)
      for (int second = 1; second <= kConfigurations; ++second) {
        const PlanarPose end = mechanism.b_in_a(first) * inverse(mechanism.b_in_a(second));
        cycles_.push_back({end, std::cos(end.heading), std::sin(end.heading)});
      }
  }

  // Calls leaf(end, codes) for every word; leaf returns false to stop. A code is 8 * (first - 1) + (second - 1).
  template <class Leaf>
  bool visit(int cycles, Leaf leaf) {
    codes_.assign(static_cast<std::size_t>(cycles), 0);
    return descend(0, {0.0, 0.0, 0.0}, 1.0, 0.0, leaf);
  }

 private:
  template <class Leaf>
  bool descend(std::size_t depth, const PlanarPose& now, double c, double s, Leaf& leaf) {
    if (depth == codes_.size()) return leaf(now, codes_);
    for (int code = 0; code < static_cast<int>(cycles_.size()); ++code) {
      const Cycle& cycle = cycles_[static_cast<std::size_t>(code)];
      codes_[depth] = static_cast<std::uint8_t>(code);
      const PlanarPose next{now.x + c * cycle.end.x - s * cycle.end.y, now.y + s * cycle.end.x + c * cycle.end.y,
                            now.heading + cycle.end.heading};
      if (!descend(depth + 1, next, c * cycle.cosine - s * cycle.sine, s * cycle.cosine + c * cycle.sine, leaf)) return false;
    }
    return true;
  }

  std::vector<Cycle> cycles_;
  std::vector<std::uint8_t> codes_;
};

void demand_few(int cycles) {
  if (cycles < 0 || cycles > kMostBruteForceCycles) throw std::invalid_argument("brute force is for 0 to 4 cycles");
}

Word to_word(const std::vector<std::uint8_t>& codes) {
  Word word;
  for (const std::uint8_t code : codes) {
    word.push_back(static_cast<std::uint8_t>(code / kConfigurations + 1));
    word.push_back(static_cast<std::uint8_t>(code % kConfigurations + 1));
  }
  return word;
}

}  // namespace

std::optional<BestWord> best_of_all_words(const Mechanism& mechanism, int cycles, const Target& target,
                                          const std::stop_token& stop) {
  demand_few(cycles);
  double best = std::numeric_limits<double>::infinity();
  std::vector<std::uint8_t> best_codes;
  std::uint32_t seen = 0;
  const bool complete = AllWords(mechanism).visit(cycles, [&](const PlanarPose& end, const std::vector<std::uint8_t>& codes) {
    if (++seen % 65536 == 0 && stop.stop_requested()) return false;
    const double square = (end.x - target.x) * (end.x - target.x) + (end.y - target.y) * (end.y - target.y);
    if (square >= best) return true;
    if (target.heading && std::abs(wrapped(end.heading - *target.heading)) > target.heading_tolerance) return true;
    best = square;
    best_codes = codes;
    return true;
  });
  if (!complete || std::isinf(best)) return std::nullopt;
  return BestWord{to_word(best_codes), std::sqrt(best)};
}

std::optional<BestWord> best_of_all_walkable_words(const Mechanism& mechanism, Passage& passage, const Stance& start, int cycles,
                                                   const Target& goal, const std::stop_token& stop) {
  demand_few(cycles);
  struct Walker {
    const Mechanism& mechanism;
    Passage& passage;
    const Target& goal;
    const std::stop_token& stop;
    Word word;
    BestWord best{{}, std::numeric_limits<double>::infinity()};

    void walk(const PlanarPose& a, int configuration, int left) {
      if (stop.stop_requested()) return;
      if (left == 0) {
        const double away = std::hypot(a.x - goal.x, a.y - goal.y);
        if (away >= best.distance) return;
        if (goal.heading && std::abs(wrapped(a.heading - *goal.heading)) > goal.heading_tolerance) return;
        best = {word, away};
        return;
      }
      const ConfigurationSet firsts = passage.reachable(true, a, set_of(configuration));
      for (int first = 1; first <= kConfigurations; ++first) {
        if (!holds(firsts, first)) continue;
        const PlanarPose b = a * mechanism.b_in_a(first);
        const ConfigurationSet seconds = passage.reachable(false, b, set_of(first));
        for (int second = 1; second <= kConfigurations; ++second) {
          if (!holds(seconds, second)) continue;
          word.push_back(static_cast<std::uint8_t>(first));
          word.push_back(static_cast<std::uint8_t>(second));
          walk(b * inverse(mechanism.b_in_a(second)), second, left - 1);
          word.pop_back();
          word.pop_back();
        }
      }
    }
  } walker{mechanism, passage, goal, stop, {}};
  walker.walk(start.a, start.configuration, cycles);
  if (stop.stop_requested() || std::isinf(walker.best.distance)) return std::nullopt;
  return walker.best;
}

std::vector<PlanarPose> ends_of_all_words(const Mechanism& mechanism, int cycles) {
  demand_few(cycles);
  std::vector<PlanarPose> ends;
  AllWords(mechanism).visit(cycles, [&](const PlanarPose& end, const std::vector<std::uint8_t>&) {
    ends.push_back(end);
    return true;
  });
  return ends;
}

}  // namespace foothold::xrobin
