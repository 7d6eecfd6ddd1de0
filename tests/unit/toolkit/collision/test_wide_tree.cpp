// The tree of four against every item, near the origin and a kilometre away, where single precision loses a tenth of a millimetre.
#include "collision/wide_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pairs.hpp"

namespace foothold::collision {
namespace {

struct Scene {
  std::vector<Bounds> items;
  Vector3d offset;
};

std::vector<Scene> scenes(Pairs& pairs) {
  std::vector<Scene> out;
  for (const double away : {0.0, 1000.0})
    for (const int count : {1, 2, 3, 4, 5, 17, 400}) {
      Scene scene{{}, Vector3d(away, -away, 0.3 * away)};
      for (int k = 0; k < count; ++k) {
        const Bounds bounds = bounds_of(pairs.box());
        scene.items.emplace_back(bounds.min() + scene.offset, bounds.max() + scene.offset);
      }
      out.push_back(std::move(scene));
    }
  return out;
}

TEST(WideTree, NamesAllThatTouchesAndLittleElse) {
  Pairs pairs(Kind::kLattice, 6);
  for (const Scene& scene : scenes(pairs)) {
    const WideTree tree(scene.items);
    for (int query = 0; query < 200; ++query) {
      Bounds at = bounds_of(pairs.capsule());
      at.translate(scene.offset);
      std::set<std::uint32_t> found;
      EXPECT_TRUE(tree.visit(at, [&](std::uint32_t k) { return found.insert(k).second; }));  // none twice
      for (std::uint32_t k = 0; k < scene.items.size(); ++k) {
        EXPECT_TRUE(found.contains(k) || !scene.items[k].intersects(at));
        EXPECT_TRUE(!found.contains(k) || scene.items[k].exteriorDistance(at) < 1e-3);
      }
    }
  }
}

TEST(WideTree, EndsWhenTheVisitorSaysSo) {
  const std::vector<Bounds> items(9, Bounds(Vector3d::Zero(), Vector3d::Ones()));
  int visited = 0;
  EXPECT_FALSE(WideTree(items).visit(items[0], [&](std::uint32_t) { return ++visited < 2; }));
  EXPECT_EQ(visited, 2);
}

TEST(WideTree, FindsTheNearestAsTryingAllDoes) {
  Pairs pairs(Kind::kAnywhere, 7);
  for (const Scene& scene : scenes(pairs)) {
    const WideTree tree(scene.items);
    for (int query = 0; query < 200; ++query) {
      Bounds at = bounds_of(pairs.capsule());
      at.translate(scene.offset);
      const auto cost = [&](std::uint32_t k) { return scene.items[k].squaredExteriorDistance(at); };
      double wanted = INFINITY;
      for (std::uint32_t k = 0; k < scene.items.size(); ++k) wanted = std::min(wanted, cost(k));
      std::size_t asked = 0;
      EXPECT_EQ(tree.nearest(at, INFINITY, [&](std::uint32_t k) { return ++asked, cost(k); }), wanted);
      EXPECT_LE(asked, scene.items.size());
      EXPECT_EQ(tree.nearest(at, 0.5 * wanted, cost), 0.5 * wanted);  // nothing is below the limit
    }
  }
}

// Where the ray enters a box, by the three pairs of planes; infinite if it misses.
double entered(const Bounds& bounds, const Vector3d& origin, const Vector3d& direction) {
  double first = 0.0, last = INFINITY;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double low = bounds.min()[k] - origin[k], high = bounds.max()[k] - origin[k];
    if (direction[k] == 0.0) {
      if (low > 0.0 || high < 0.0) return INFINITY;
      continue;
    }
    first = std::max(first, std::min(low / direction[k], high / direction[k]));
    last = std::min(last, std::max(low / direction[k], high / direction[k]));
  }
  return first <= last ? first : INFINITY;
}

TEST(WideTree, FindsWhatARayMeetsFirstAsTryingAllDoes) {
  for (const Kind kind : {Kind::kAnywhere, Kind::kLattice}) {
    Pairs pairs(kind, 8);
    int met = 0;
    for (const Scene& scene : scenes(pairs)) {
      const WideTree tree(scene.items);
      for (int query = 0; query < 300; ++query) {
        const Capsule capsule = pairs.capsule();
        const Vector3d origin = capsule.a + scene.offset, way = capsule.b - capsule.a;
        const Vector3d axis = Vector3d::Unit(query % 3) * (query % 2 == 0 ? 1.0 : -1.0);
        const Vector3d direction = query % 5 == 0 || way.norm() < 1e-6 ? axis : Vector3d(way.normalized());
        double wanted = INFINITY;
        for (const Bounds& item : scene.items) wanted = std::min(wanted, entered(item, origin, direction));
        const auto cost = [&](std::uint32_t k) { return entered(scene.items[k], origin, direction); };
        EXPECT_EQ(tree.first(origin, direction, INFINITY, cost), wanted);
        met += std::isfinite(wanted) ? 1 : 0;
      }
    }
    EXPECT_GT(met, 300);
  }
}

}  // namespace
}  // namespace foothold::collision
