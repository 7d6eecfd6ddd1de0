// Which of the merged poses can really be reached from a place among obstacles, found out as far as it is asked.
//
// Rooted at the start it looks forward; rooted at a pose of body A at the end of a plan it looks backward: a plan read from its
// end is a plan again, since every motion of Xrobin can be reversed.
#pragma once

#include "origins.hpp"
#include "passage.hpp"
#include "route.hpp"

namespace foothold::xrobin {

// Not thread-safe.
class ReachTree {
 public:
  ReachTree(const HalfCycles& half_cycles, const Origins& origins, Passage& passage, int most_levels);
  // Body A at `root`. Forward: the robot stands in `configuration` there. Backward (0): in any.
  void plant(const PlanarPose& root, int configuration);
  // The configurations in which pose `id` of level `n` can be arrived at; empty: it cannot be reached.
  ConfigurationSet reach(int n, std::uint32_t id);
  // Whether it is known already that the pose cannot be reached.
  bool refuted(int n, std::uint32_t id) const;
  // The pose in the world.
  PlanarPose pose(int n, std::uint32_t id) const;
  // A valid chain from the root to the pose arriving in one of `arrivals`, which must meet reach(n, id): the configurations
  // of its half cycles, root first.
  Word chain(int n, std::uint32_t id, ConfigurationSet arrivals);

 private:
  struct Memo {
    std::vector<std::uint32_t> epoch;
    std::vector<ConfigurationSet> reach;
  };
  bool leads(int n, std::uint32_t below, int configuration);

  const HalfCycles* half_cycles_;
  const Origins* origins_;
  Passage* passage_;
  PlanarPose root_;
  double cosine_ = 1.0;
  double sine_ = 0.0;
  int configuration_ = 0;
  std::uint32_t epoch_ = 0;
  std::vector<Memo> memo_;
};

}  // namespace foothold::xrobin
