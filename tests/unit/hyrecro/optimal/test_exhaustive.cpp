// Against an exhaustive search, breadth first, over all footholds of a coarse lattice on small faces.
#include <queue>

#include "climbing.hpp"
#include "hyrecro/reach/reachability.hpp"

namespace foothold::hyrecro {
namespace {

// Two plates at a right angle that meet along the Y axis: concave.
truss::Truss corner() {
  return truss::parse_truss(
      "kind: truss\ndescription: corner\nfaces:\n"
      "  - {name: floor, polygon: [[0, 0, 0], [0.8, 0, 0], [0.8, 0.5, 0], [0, 0.5, 0]], normal: [0, 0, 1]}\n"
      "  - {name: wall, polygon: [[0, 0, 0], [0, 0.5, 0], [0, 0.5, 0.8], [0, 0, 0.8]], normal: [1, 0, 0]}\n");
}

// Places 0.1 m apart, headings along the edges, the transition footholds, and both ends.
std::vector<Foothold> lattice(const PreparedTruss& scene, const Foothold& start, const Foothold& goal) {
  std::vector<Foothold> out{start, goal};
  for (const TransitionFoothold& one : scene.transitions.all()) out.push_back(one.foothold);
  for (int face = 0; face < static_cast<int>(scene.truss.faces.size()); ++face) {
    Eigen::AlignedBox2d box;
    for (const Vector2d& v : scene.truss.faces[static_cast<std::size_t>(face)].outline) box.extend(v);
    for (double x = box.min().x() + 0.05; x < box.max().x(); x += 0.1)
      for (double y = box.min().y() + 0.05; y < box.max().y(); y += 0.1)
        for (int side = 0; side < 2; ++side) {
          const Foothold one{face, {x, y}, side * 0.5 * std::numbers::pi};
          if (plate_on_face(robot(), scene.truss.faces[static_cast<std::size_t>(face)], one)) out.push_back(one);
        }
  }
  return out;
}

// Strides from the first foothold to the second over all others; a transition only between the first two and those of the scene.
int least_strides(const PreparedTruss& scene, const std::vector<Foothold>& all) {
  const auto exact = make_exact(robot(), kClearance);
  const std::size_t named = 2 + scene.transitions.all().size();
  std::vector<int> strides(all.size(), -1);
  std::queue<std::size_t> open;
  strides[0] = 0;
  open.push(0);
  while (!open.empty() && strides[1] < 0) {
    const std::size_t at = open.front();
    open.pop();
    const Isometry3d sole = pose_of(scene.truss, all[at]);
    for (std::size_t next = 0; next < all.size(); ++next) {
      if (strides[next] >= 0 || (all[next].face != all[at].face && std::max(next, at) >= named)) continue;
      const auto clear = [&](const Coordinates& c) { return scene.obstacles.free(bodies_at(robot(), c, sole), kClearance); };
      if (!exact->reach(sole.inverse() * pose_of(scene.truss, all[next]), clear).reachable) continue;
      strides[next] = strides[at] + 1;
      open.push(next);
    }
  }
  return strides[1];
}

TEST(Exhaustive, NoRouteOverALatticeTakesFewerStrides) {
  const auto scene = prepared(corner());
  std::mt19937_64 random(41);
  int equal = 0, reached = 0;
  const int routes = long_tests() ? 40 : 6;
  for (int i = 0; i < routes; ++i) {
    const Vector3d low(0.1 + 0.05 * static_cast<double>(random() % 13), 0.1 + 0.05 * static_cast<double>(random() % 7), 0.0);
    const Vector3d high(0.0, 0.1 + 0.05 * static_cast<double>(random() % 7), 0.25 + 0.05 * static_cast<double>(random() % 10));
    const Foothold start = foothold_on(scene->truss, low, {0, 0, 90.0 * static_cast<double>(random() % 4)});
    const Foothold goal =
        i % 3 == 0 ? foothold_on(scene->truss, {0.65, 0.35, 0.0}, {0, 0, 0}) : foothold_on(scene->truss, high, {0, 90, 0});
    const int least = least_strides(*scene, lattice(*scene, start, goal));
    const Found found = plan_optimal(robot(), *scene, start, goal, {}, {}, {});
    if (least < 0) continue;
    ++reached;
    ASSERT_EQ(found.outcome, Found::Outcome::kReached) << i << ": " << found.failure.message;
    expect_climbable(*scene, found.route);
    EXPECT_LE(found.cost, least) << i;
    EXPECT_LE(found.lower_bound, least) << i;
    equal += found.cost == least ? 1 : 0;
  }
  EXPECT_GE(reached, routes / 2);
  EXPECT_GE(equal, reached / 2);
}

}  // namespace
}  // namespace foothold::hyrecro
