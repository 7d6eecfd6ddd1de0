// The broad phase against every pair.
#include "collision/bound_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "pairs.hpp"

namespace foothold::collision {
namespace {

TEST(BoundTree, NamesWhatTouchesAndNothingElse) {
  for (const int count : {0, 1, 2, 3, 17, 400}) {
    Pairs pairs(Kind::kLattice, 6);
    std::vector<Bounds> items;
    for (int k = 0; k < count; ++k) items.push_back(bounds_of(pairs.box()));
    const BoundTree tree(items);
    for (int query = 0; query < 200; ++query) {
      const Bounds at = bounds_of(pairs.capsule());
      std::vector<std::uint32_t> found, expected;
      EXPECT_TRUE(tree.visit(at, [&](std::uint32_t k) {
        found.push_back(k);
        return true;
      }));
      for (std::uint32_t k = 0; k < items.size(); ++k)
        if (items[k].intersects(at)) expected.push_back(k);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(BoundTree, EndsWhenTheVisitorSaysSo) {
  const std::vector<Bounds> items(5, Bounds(Vector3d::Zero(), Vector3d::Ones()));
  int visited = 0;
  EXPECT_FALSE(BoundTree(items).visit(items[0], [&](std::uint32_t) { return ++visited < 2; }));
  EXPECT_EQ(visited, 2);
}

TEST(BoundTree, BoundsHoldTheirBodies) {
  Pairs pairs(Kind::kAnywhere, 7);
  for (int k = 0; k < 1000; ++k) {
    const Box box = pairs.box();
    const Capsule capsule = pairs.capsule();
    const Vector3d unit(pairs.integer(0, 1) * 2 - 1, pairs.integer(0, 1) * 2 - 1, pairs.integer(0, 1) * 2 - 1);
    EXPECT_TRUE(grown(bounds_of(box), 1e-12).contains(Vector3d(box.pose * box.half.cwiseProduct(unit))));
    EXPECT_TRUE(grown(bounds_of(capsule), 1e-12).contains(Vector3d(capsule.a + capsule.radius * unit.normalized())));
    EXPECT_TRUE(grown(bounds_of(capsule), 1e-12).contains(Vector3d(capsule.b + capsule.radius * unit.normalized())));
  }
}

}  // namespace
}  // namespace foothold::collision
