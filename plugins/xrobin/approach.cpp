// Weighted A*: cycles so far, and twice what the way left would take at full advance.
#include "approach.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::xrobin {
namespace {

constexpr double kCell = 0.01;    // m
constexpr double kWeight = 2.0;   // of the cycles still to go
constexpr double kFarAway = 1e6;  // m: what counts as no way at all, still in the order of the straight distance

std::uint64_t cell_of(const Stance& stance) {
  const auto x = static_cast<std::uint64_t>(std::llround(stance.a.x / kCell) + (1 << 24));
  const auto y = static_cast<std::uint64_t>(std::llround(stance.a.y / kCell) + (1 << 24));
  const auto eighth = static_cast<std::uint64_t>(std::llround(stance.a.heading / (0.25 * std::numbers::pi)) & 7);
  return ((x << 26 | y) << 3 | eighth) << 3 | static_cast<std::uint64_t>(stance.configuration - 1);
}

}  // namespace

Approach::Approach(const Mechanism& mechanism, Passage& passage, const PathField& field, const Stance& start, int most_cycles)
    : mechanism_(mechanism), passage_(passage), field_(field), most_cycles_(most_cycles) {
  add(start, 0, -1, 0, 0);
}

void Approach::add(const Stance& stance, int cycles, int parent, int first, int second) {
  if (!seen_.insert(cell_of(stance)).second) return;
  const double away = std::min(field_.distance(stance.a.x, stance.a.y), kFarAway);
  const int node = static_cast<int>(nodes_.size());
  nodes_.push_back({stance, away, cycles, parent, static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second)});
  open_.push({cycles + kWeight * away / mechanism_.longest_cycle(), node});
  if (away < nodes_[static_cast<std::size_t>(nearest_)].away) nearest_ = node;
}

void Approach::expand(int at) {
  const Node node = nodes_[static_cast<std::size_t>(at)];
  if (node.cycles >= most_cycles_) return;
  const ConfigurationSet firsts = passage_.reachable(true, node.stance.a, set_of(node.stance.configuration));
  for (int first = 1; first <= kConfigurations; ++first) {
    if (!holds(firsts, first)) continue;
    const PlanarPose b = node.stance.a * mechanism_.b_in_a(first);
    const ConfigurationSet seconds = passage_.reachable(false, b, set_of(first));
    for (int second = 1; second <= kConfigurations; ++second)
      if (holds(seconds, second)) add({b * inverse(mechanism_.b_in_a(second)), second}, node.cycles + 1, at, first, second);
  }
}

int Approach::go_on(double near, std::size_t most_nodes) {
  while (!open_.empty() && expanded_ < most_nodes && !passage_.stopped()) {
    const int node = open_.top().node;
    if (nodes_[static_cast<std::size_t>(node)].away <= near) return node;
    open_.pop();
    expand(node);
    ++expanded_;
  }
  return -1;
}

Word Approach::word(int node) const {
  Word word;
  for (; nodes_[static_cast<std::size_t>(node)].parent >= 0; node = nodes_[static_cast<std::size_t>(node)].parent) {
    word.push_back(nodes_[static_cast<std::size_t>(node)].second);
    word.push_back(nodes_[static_cast<std::size_t>(node)].first);
  }
  std::reverse(word.begin(), word.end());
  return word;
}

}  // namespace foothold::xrobin
