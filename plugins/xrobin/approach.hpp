// Best-first search for goals that lie beyond the cycles that are searched exactly, or behind obstacles: brings the robot near.
//
// Nodes are stances after whole cycles, one for each cell of place, heading and configuration, so it is complete in practice but
// proves nothing; every motion in it is judged without gaps all the same.
#pragma once

#include <queue>
#include <unordered_set>
#include <vector>

#include "pair_search.hpp"
#include "passage.hpp"
#include "path_field.hpp"
#include "route.hpp"

namespace foothold::xrobin {

// Not thread-safe; for one request. Keeps references to its arguments.
class Approach {
 public:
  Approach(const Mechanism& mechanism, Passage& passage, const PathField& field, const Stance& start, int most_cycles);

  // Goes on until a stance lies within `near` m of the goal (along the field); its index, or -1 when nothing is left to
  // look at, `most_nodes` have been looked at in all, or it was stopped.
  int go_on(double near, std::size_t most_nodes);
  // The stance nearest to the goal so far.
  int nearest() const { return nearest_; }

  const Stance& stance(int node) const { return nodes_[static_cast<std::size_t>(node)].stance; }
  int cycles(int node) const { return nodes_[static_cast<std::size_t>(node)].cycles; }
  // From the start to the node.
  Word word(int node) const;

 private:
  struct Node {
    Stance stance;
    double away;  // m, along the field
    int cycles;
    int parent;
    std::uint8_t first, second;  // configurations of the cycle that led here
  };
  struct Entry {
    double value;
    int node;
    bool operator>(const Entry& other) const { return value != other.value ? value > other.value : node > other.node; }
  };

  void add(const Stance& stance, int cycles, int parent, int first, int second);
  void expand(int node);

  const Mechanism& mechanism_;
  Passage& passage_;
  const PathField& field_;
  int most_cycles_;
  std::vector<Node> nodes_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::unordered_set<std::uint64_t> seen_;
  std::size_t expanded_ = 0;
  int nearest_ = 0;
};

}  // namespace foothold::xrobin
