// Builds the levels one on the other: eight children of each pose, merged by a hash of the rounded position.
#include "half_cycles.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace foothold::xrobin {
namespace {

constexpr double kMergeDistance = 1e-12;  // m, in x and in y
constexpr double kMergeAngle = 1e-12;     // rad
constexpr double kCell = 1e-10;  // m, of the hash; a pair that a cell's edge divides stays two poses, which costs only time

// Open addressing over the indices of a level's poses, each beside the upper half of its hash, so that few poses are looked at.
class PoseHash {
 public:
  explicit PoseHash(std::size_t poses) {
    std::size_t capacity = 64;
    while (capacity < 2 * poses) capacity *= 2;
    slots_.assign(capacity, kFree);
  }

  // The hash of a pose, to be given to insert() some time later, when its slot has come from memory.
  std::uint64_t announce(double x, double y, std::uint16_t turn) const {
    const std::uint64_t hashed = hash(x, y, turn);
    __builtin_prefetch(&slots_[hashed & (slots_.size() - 1)]);
    return hashed;
  }

  // Appends the pose unless the level holds it already; gives its index.
  std::uint32_t insert(PoseLevel& level, std::uint64_t hashed, double x, double y, std::uint16_t turn, std::uint32_t origin) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hashed & mask;
    while (slots_[slot] != kFree) {
      if ((slots_[slot] ^ hashed) >> 32 == 0) {
        const auto k = static_cast<std::uint32_t>(slots_[slot]);
        if (level.turn[k] == turn && std::abs(level.x[k] - x) <= kMergeDistance && std::abs(level.y[k] - y) <= kMergeDistance)
          return k;
      }
      slot = (slot + 1) & mask;
    }
    const auto k = static_cast<std::uint32_t>(level.size());
    slots_[slot] = (hashed & ~std::uint64_t{0xFFFFFFFF}) | k;
    level.x.push_back(x);
    level.y.push_back(y);
    level.turn.push_back(turn);
    level.origin.push_back(origin);
    return k;
  }

 private:
  static constexpr std::uint64_t kFree = std::numeric_limits<std::uint64_t>::max();

  static std::uint64_t hash(double x, double y, std::uint16_t turn) {
    const auto a = static_cast<std::uint64_t>(std::llround(x / kCell));
    const auto b = static_cast<std::uint64_t>(std::llround(y / kCell));
    std::uint64_t h = a * 0x9E3779B97F4A7C15ull ^ (b + turn) * 0xC2B2AE3D27D4EB4Full;
    h ^= h >> 29;
    h *= 0xBF58476D1CE4E5B9ull;
    return h ^ (h >> 32);
  }

  std::vector<std::uint64_t> slots_;
};

}  // namespace

Turns::Turns(const Mechanism& mechanism, int half_cycles) : most_(half_cycles) {
  struct Sum {
    double angle;
    int i;
    int j;
  };
  std::vector<Sum> sums;
  for (int i = -most_; i <= most_; ++i)
    for (int j = -most_; j <= most_; ++j) {
      if (std::abs(i) + std::abs(j) > most_) continue;
      const double angle = i * mechanism.quarter_turn() + j * mechanism.eighth_turn();
      const double full = 2.0 * std::numbers::pi;
      // What is a hair below a full turn is no turn.
      sums.push_back({angle - full * std::floor(angle / full + kMergeAngle), i, j});
    }
  std::sort(sums.begin(), sums.end(), [](const Sum& a, const Sum& b) { return a.angle < b.angle; });
  index_.assign(static_cast<std::size_t>((2 * most_ + 1) * (2 * most_ + 1)), 0);
  for (const Sum& sum : sums) {
    if (angle_.empty() || sum.angle - angle_.back() > kMergeAngle) {
      angle_.push_back(sum.angle);
      cosine_.push_back(std::cos(sum.angle));
      sine_.push_back(std::sin(sum.angle));
      quarters_.push_back(sum.i);
      eighths_.push_back(sum.j);
    } else if (std::abs(sum.i) + std::abs(sum.j) < std::abs(quarters_.back()) + std::abs(eighths_.back())) {
      // The shortest sum stands for its angle, so that what follows it stays within the table.
      quarters_.back() = sum.i;
      eighths_.back() = sum.j;
    }
    index_[index(sum.i, sum.j)] = static_cast<std::uint16_t>(angle_.size() - 1);
  }
}

std::uint16_t Turns::after(std::size_t turn, const Configuration& configuration, int sign) const {
  return index_[index(quarters_[turn] + sign * configuration.quarter_turns, eighths_[turn] + sign * configuration.eighth_turns)];
}

HalfCycles::HalfCycles(const Mechanism& mechanism) : mechanism_(mechanism), turns_(mechanism, kMost) {
  PoseLevel start;
  start.x = start.y = {0.0};
  start.turn = {turns_.none()};
  start.origin = {0};
  levels_.push_back(std::move(start));
}

bool HalfCycles::grow(int wanted, const std::stop_token& stop) {
  while (levels() < wanted) {
    PoseLevel& below = levels_.back();
    const bool b_moves = levels() % 2 == 0;
    PoseLevel next;
    below.next.resize(below.size() * kConfigurations);
    PoseHash seen(below.size() * kConfigurations);
    struct Child {
      std::uint64_t hashed;
      double x, y;
      std::uint16_t turn;
    };
    // Some parents' children are announced before those of the first are inserted.
    constexpr std::size_t kAhead = 4;
    std::array<std::array<Child, kConfigurations>, kAhead> children;
    for (std::size_t k = 0; k < below.size() + kAhead; ++k) {
      if (k % 4096 == 0 && stop.stop_requested()) return false;
      auto& these = children[k % kAhead];
      if (k >= kAhead)
        for (std::size_t c = 0; c < kConfigurations; ++c) {
          const std::size_t code = (k - kAhead) * kConfigurations + c;
          below.next[code] =
              seen.insert(next, these[c].hashed, these[c].x, these[c].y, these[c].turn, static_cast<std::uint32_t>(code));
        }
      if (k >= below.size()) continue;
      for (const Configuration& c : mechanism_.configurations()) {
        Child& child = these[static_cast<std::size_t>(c.number - 1)];
        child.turn = turns_.after(below.turn[k], c, b_moves ? 1 : -1);
        // The slot lies along the y axis of body A, which is the one that moves in the second half of a cycle.
        const std::size_t slot = b_moves ? below.turn[k] : child.turn;
        const double along = b_moves ? c.y : -c.y;
        child.x = below.x[k] - turns_.sine(slot) * along;
        child.y = below.y[k] + turns_.cosine(slot) * along;
        child.hashed = seen.announce(child.x, child.y, child.turn);
      }
    }
    levels_.push_back(std::move(next));
  }
  return true;
}

Word HalfCycles::word(int n, std::uint32_t id) const {
  Word word(static_cast<std::size_t>(n));
  for (int k = n; k > 0; --k) {
    const std::uint32_t origin = level(k).origin[id];
    word[static_cast<std::size_t>(k - 1)] = static_cast<std::uint8_t>(origin % kConfigurations + 1);
    id = origin / kConfigurations;
  }
  return word;
}

double HalfCycles::merge_angle(int n) const { return n * (kMergeAngle + 1e-14); }

double HalfCycles::merge_bound(int n) const {
  // Each level adds its own merging and turns the next link by the angles merged so far; 1e-14 m is far above the rounding of a
  // sum.
  double position = 0.0;
  for (int k = 0; k < n; ++k) position += std::sqrt(2.0) * kMergeDistance + merge_angle(k) * mechanism_.travel() + 1e-14;
  return position;
}

}  // namespace foothold::xrobin
