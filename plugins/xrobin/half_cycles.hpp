// All poses that n half cycles can reach, each once: 8^n words fall together into few poses, because cycles are T_i T_j^-1 and
// the turns are few. Level 7 has 634,488 poses with b and p as printed and 91,914 with exact turns, of 2,097,152 words.
//
// Poses that differ by rounding only are merged; merge_bound() says how far the pose of a word can lie from the pose that stands
// for it, so that a search over poses proves something about all words.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "word.hpp"

namespace foothold::xrobin {

// Pose k of a level is (x[k], y[k]) in m and the heading with the index turn[k].
struct PoseLevel {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<std::uint16_t> turn;
  std::vector<std::uint32_t> origin;  // 8 * (index in the level below) + configuration number - 1
  std::vector<std::uint32_t> next;    // at 8 * k + number - 1: pose k's successor in the level above, once that is made
  std::size_t size() const { return x.size(); }
};

// The headings that up to `half_cycles` half cycles can add up to: i * quarter turn + j * eighth of a turn, |i| + |j| <=
// half_cycles.
class Turns {
 public:
  Turns(const Mechanism& mechanism, int half_cycles);
  std::size_t size() const { return angle_.size(); }
  double angle(std::size_t turn) const { return angle_[turn]; }  // rad, in [0, 2 pi)
  double cosine(std::size_t turn) const { return cosine_[turn]; }
  double sine(std::size_t turn) const { return sine_[turn]; }
  // The heading after adding (sign = 1) or taking back (sign = -1) the turn of a configuration.
  std::uint16_t after(std::size_t turn, const Configuration& configuration, int sign) const;
  std::uint16_t none() const { return index_[index(0, 0)]; }

 private:
  std::size_t index(int i, int j) const { return static_cast<std::size_t>((i + most_) * (2 * most_ + 1) + j + most_); }
  int most_;
  std::vector<double> angle_, cosine_, sine_;
  std::vector<int> quarters_, eighths_;  // of the angle that stands for the merged ones
  std::vector<std::uint16_t> index_;
};

// Not thread-safe while it grows.
class HalfCycles {
 public:
  static constexpr int kMost = 8;

  explicit HalfCycles(const Mechanism& mechanism);
  // Makes all levels up to `level` (at most kMost). Returns false if it was stopped before the end; calling it again goes on.
  bool grow(int level, const std::stop_token& stop);
  int levels() const { return static_cast<int>(levels_.size()) - 1; }
  // After an odd number of half cycles the poses are body B's, after an even one body A's, in the frame of A before the first.
  const PoseLevel& level(int n) const { return levels_[static_cast<std::size_t>(n)]; }
  const Turns& turns() const { return turns_; }
  const Mechanism& mechanism() const { return mechanism_; }
  // The configurations that lead to pose `id` of level `n`, first to last.
  Word word(int n, std::uint32_t id) const;
  // In m: no word's pose in level n is farther than this from the pose that stands for it.
  double merge_bound(int n) const;
  // The same for its heading, in rad.
  double merge_angle(int n) const;

 private:
  Mechanism mechanism_;
  Turns turns_;
  std::vector<PoseLevel> levels_;
};

}  // namespace foothold::xrobin
