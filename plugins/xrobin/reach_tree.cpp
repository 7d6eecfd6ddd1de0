// Recursion over the origins of a pose, each pose once for a root.
#include "reach_tree.hpp"

#include <stdexcept>

namespace foothold::xrobin {

ReachTree::ReachTree(const HalfCycles& half_cycles, const Origins& origins, Passage& passage, int most_levels)
    : half_cycles_(&half_cycles), origins_(&origins), passage_(&passage) {
  for (int n = 0; n <= most_levels; ++n) {
    const std::size_t size = half_cycles.level(n).size();
    memo_.push_back({std::vector<std::uint32_t>(size, 0), std::vector<ConfigurationSet>(size, 0)});
  }
}

void ReachTree::plant(const PlanarPose& root, int configuration) {
  root_ = root;
  cosine_ = std::cos(root.heading);
  sine_ = std::sin(root.heading);
  configuration_ = configuration;
  ++epoch_;
}

PlanarPose ReachTree::pose(int n, std::uint32_t id) const {
  const PoseLevel& level = half_cycles_->level(n);
  return {root_.x + cosine_ * level.x[id] - sine_ * level.y[id], root_.y + sine_ * level.x[id] + cosine_ * level.y[id],
          root_.heading + half_cycles_->turns().angle(level.turn[id])};
}

// Whether the pose below can be stood on, and the configuration taken from there.
bool ReachTree::leads(int n, std::uint32_t below, int configuration) {
  // Backward there is no motion at the root: the robot stands there at the end of its plan.
  if (n == 1 && configuration_ == 0)
    return passage_->surroundings().clear_at_rest({root_, root_ * half_cycles_->mechanism().b_in_a(configuration)});
  const ConfigurationSet before = reach(n - 1, below);
  return before != 0 && passage_->connected((n - 1) % 2 == 0, pose(n - 1, below), before, set_of(configuration));
}

bool ReachTree::refuted(int n, std::uint32_t id) const {
  const Memo& memo = memo_[static_cast<std::size_t>(n)];
  return memo.epoch[id] == epoch_ && memo.reach[id] == 0;
}

ConfigurationSet ReachTree::reach(int n, std::uint32_t id) {
  if (n == 0) return configuration_ == 0 ? ConfigurationSet{0xFF} : set_of(configuration_);
  Memo& memo = memo_[static_cast<std::size_t>(n)];
  if (memo.epoch[id] == epoch_) return memo.reach[id];
  ConfigurationSet out = 0;
  for (const std::uint32_t code : origins_->of(n, id)) {
    const int configuration = static_cast<int>(code % kConfigurations) + 1;
    if (!holds(out, configuration) && leads(n, code / kConfigurations, configuration)) out |= set_of(configuration);
  }
  memo.epoch[id] = epoch_;
  memo.reach[id] = out;
  return out;
}

Word ReachTree::chain(int n, std::uint32_t id, ConfigurationSet arrivals) {
  if (n == 0) return {};
  for (const std::uint32_t code : origins_->of(n, id)) {
    const int configuration = static_cast<int>(code % kConfigurations) + 1;
    const std::uint32_t below = code / kConfigurations;
    if (!holds(arrivals, configuration) || !leads(n, below, configuration)) continue;
    ConfigurationSet before = reach(n - 1, below);
    if (!(n == 1 && configuration_ == 0))
      before &= passage_->reachable((n - 1) % 2 == 0, pose(n - 1, below), set_of(configuration));
    Word word = chain(n - 1, below, before);
    word.push_back(static_cast<std::uint8_t>(configuration));
    return word;
  }
  throw std::logic_error("a chain was asked for that reach() does not know");
}

}  // namespace foothold::xrobin
