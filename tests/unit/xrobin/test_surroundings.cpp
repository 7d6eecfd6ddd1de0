// Clear or blocked, without gaps: against dense samples measured in another way.
#include <gtest/gtest.h>

#include <limits>

#include "box.hpp"
#include "fixtures.hpp"
#include "passage.hpp"
#include "scenery.hpp"

namespace foothold::xrobin {
namespace {

using geometry::Polygon;
using geometry::Vector2d;

Polygon outline(const Block& block, const PlanarPose& pose) {
  Polygon out;
  for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const PlanarPose at = pose * PlanarPose{sx * block.half_x, sy * block.half_y, 0.0};
    out.emplace_back(at.x, at.y);
  }
  return out;
}

// Of what moves: the moving body and the pistons.
double distance_of_moving(const Mechanism& m, const Bodies& bodies, bool a_holds, const BodyPoses& poses, const Polygon& obstacle) {
  double least = geometry::distance(a_holds ? outline(bodies.b, poses.b) : outline(bodies.a, poses.a), obstacle);
  for (const PistonAxis& axis : piston_axes(m.lengths(), poses))
    least = std::min(least, geometry::distance(obstacle, axis.on_a, axis.on_b) - bodies.piston_radius);
  return least;
}

TEST(Surroundings, CallAnEdgeClearIfAndOnlyIfNoPostureOnItComesTooNear) {
  const Ring ring{mechanism()};
  const Bodies bodies = Bodies::from_model(robot(), ring.mechanism());
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  constexpr double kClearance = 0.002;
  constexpr int kSamples = 1000;
  int clear = 0;
  int blocked = 0;
  for (int round = 0; round < 60; ++round) {
    // Needles among them, which samples far apart would step over.
    const std::vector<geometry::Obstacle> obstacles = random_obstacles(random, 2, 0.02, 0.17, round % 3 == 0 ? 0.002 : 0.05);
    const Surroundings surroundings(ring, bodies, obstacles, kClearance);
    const PlanarPose held{0.01 * unit(random), 0.01 * unit(random), 3.0 * unit(random)};
    for (const bool a_holds : {true, false})
      for (int from = 1; from <= 8; ++from) {
        const RingEdge& edge = ring.edge(from);
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= kSamples; ++k) {
          const SlotPosture at = ring.at(edge, edge.phi_from + (edge.phi_to - edge.phi_from) * k / kSamples);
          const PlanarPose b_in_a{0.0, at.y, at.phi};
          const BodyPoses poses = a_holds ? BodyPoses{held, held * b_in_a} : BodyPoses{held * inverse(b_in_a), held};
          for (const geometry::Obstacle& o : obstacles)
            least = std::min(least, distance_of_moving(ring.mechanism(), bodies, a_holds, poses, o.polygon));
        }
        if (surroundings.edge_clear(a_holds, held, edge)) {
          EXPECT_GT(least, kClearance);
          ++clear;
        } else {
          EXPECT_LT(least, kClearance + Surroundings::kResolution + 1e-4);
          ++blocked;
        }
      }
  }
  EXPECT_GT(clear, 100);
  EXPECT_GT(blocked, 100);
}

TEST(Surroundings, MeasureTheRobotAtRest) {
  const Ring ring{mechanism()};
  const Bodies bodies = Bodies::from_model(robot(), ring.mechanism());
  std::mt19937_64 random(22);
  for (int round = 0; round < 100; ++round) {
    const std::vector<geometry::Obstacle> obstacles = random_obstacles(random, 3, 0.0, 0.3, 0.06);
    const Surroundings surroundings(ring, bodies, obstacles, 0.001);
    const PlanarPose a{0.02, -0.01, 0.1 * round};
    const BodyPoses poses{a, a * ring.mechanism().b_in_a(1 + round % 8)};
    double least = std::numeric_limits<double>::infinity();
    for (const geometry::Obstacle& o : obstacles) {
      least = std::min(least, distance_of_moving(ring.mechanism(), bodies, true, poses, o.polygon));
      least = std::min(least, geometry::distance(outline(bodies.a, poses.a), o.polygon));
    }
    EXPECT_NEAR(surroundings.nearest(poses).distance, least, 1e-12);
  }
}

TEST(Box, DistanceIsThatOfThePolygons) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int round = 0; round < 2000; ++round) {
    const Polygon polygon = random_obstacles(random, 1, 0.0, 0.3, 0.1 * (round % 9))[0].polygon;
    const PlanarPose at{0.1 * unit(random), 0.1 * unit(random), 3.0 * unit(random)};
    const double exact = geometry::distance(outline({0.1, 0.03, 0.0}, at), polygon);
    EXPECT_NEAR(box_distance(box_at(at, 0.1, 0.03), polygon), exact, 1e-12);
    const double bound = box_distance(box_at(at, 0.1, 0.03), polygon, 0.02);
    EXPECT_TRUE(std::abs(bound - exact) < 1e-12 || (bound > 0.02 && bound <= exact + 1e-12));
    const Vector2d end(0.2 * unit(random), 0.2 * unit(random));
    EXPECT_NEAR(box_distance(box_between({at.x, at.y}, end, 0.004), polygon),
                geometry::distance(polygon, Vector2d(at.x, at.y), end) - 0.004, 1e-12);
  }
  EXPECT_EQ(box_distance(box_at({}, 0.1, 0.03), Polygon{{-1, -1}, {1, -1}, {0, 2}}), 0.0);
}

TEST(Passage, GoesTheOtherWayRoundTheRingIfTheShorterOneIsBlocked) {
  const Ring ring{mechanism()};
  const Bodies bodies = Bodies::from_model(robot(), ring.mechanism());
  // From 1 to 3 B's left end sweeps over the upper left corner; on the other way round it does not come there.
  const auto post = [](double x) {
    return Polygon{{x - 0.002, 0.074}, {x + 0.002, 0.074}, {x + 0.002, 0.078}, {x - 0.002, 0.078}};
  };
  const Surroundings one(ring, bodies, {{"left", post(-0.09)}}, 0.001);
  Passage passage(one, {});
  EXPECT_EQ(shorter_way(1, 3), RingWay::kUp);
  const std::optional<RingWay> way = passage.way(true, {}, 1, 3);
  ASSERT_TRUE(way.has_value());
  EXPECT_EQ(*way, RingWay::kDown);
  EXPECT_TRUE(passage.connected(true, {}, set_of(1), set_of(3)));
  EXPECT_EQ(passage.reachable(true, {}, set_of(1)), 0xFF);

  // A second post on the other side leaves no way out of configuration 1.
  const Surroundings both(ring, bodies, {{"left", post(-0.09)}, {"right", post(0.09)}}, 0.001);
  Passage closed(both, {});
  EXPECT_EQ(closed.reachable(true, {}, set_of(1)), set_of(1));
  EXPECT_FALSE(closed.way(true, {}, 1, 3).has_value());
  EXPECT_FALSE(closed.connected(true, {}, set_of(1), set_of(3)));
  EXPECT_TRUE(closed.connected(true, {}, set_of(2), set_of(8)));
}

}  // namespace
}  // namespace foothold::xrobin
