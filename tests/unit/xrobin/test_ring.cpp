// The ring of configurations: closed-form curves, one piston at a time, round the singular posture.
#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "ring.hpp"

namespace foothold::xrobin {
namespace {

class RingOf : public testing::TestWithParam<Lengths> {};

INSTANTIATE_TEST_SUITE_P(Lengths, RingOf,
                         testing::Values(Lengths{0.01859, 0.10131, 0.103, 0.130},
                                         Lengths{0.018590460130, 0.101308414222, 0.103, 0.130}, Lengths{0.02, 0.1, 0.105, 0.135}));

TEST_P(RingOf, NeighboursAreJoinedByTheStrokeOfOnePiston) {
  const Ring ring{Mechanism(GetParam())};
  const Mechanism& m = ring.mechanism();
  for (int from = 1; from <= 8; ++from) {
    const RingEdge& edge = ring.edge(from);
    const Configuration& a = m.configuration(edge.from);
    const Configuration& b = m.configuration(edge.to);
    EXPECT_EQ((a.l_extended != b.l_extended) + (a.r_extended != b.r_extended), 1) << from;
    EXPECT_NEAR(ring.at(edge, a.phi).y, a.y, 1e-12) << from;
    EXPECT_NEAR(ring.at(edge, b.phi).y, b.y, 1e-12) << from;
    double last = edge.l_moves ? m.pistons(a.phi, a.y).l : m.pistons(a.phi, a.y).r;
    const double sign = (edge.l_moves ? b.l_extended : b.r_extended) ? 1.0 : -1.0;
    for (int k = 1; k <= 200; ++k) {
      const SlotPosture at = ring.at(edge, a.phi + (b.phi - a.phi) * k / 200.0);
      const Pistons is = m.pistons(at.phi, at.y);
      EXPECT_NEAR(edge.l_moves ? is.r : is.l, edge.kept, 1e-12);
      const double moving = edge.l_moves ? is.l : is.r;
      EXPECT_GT(sign * (moving - last), 0.0) << from << " " << k;  // the stroke never turns back
      last = moving;
      EXPECT_GT(at.y * at.y * std::cos(at.phi) + m.lengths().b * m.lengths().p * std::pow(std::sin(at.phi), 2), 1e-4);
    }
  }
}

TEST_P(RingOf, SlopeBoundHolds) {
  const Ring ring{Mechanism(GetParam())};
  for (int from = 1; from <= 8; ++from) {
    const RingEdge& edge = ring.edge(from);
    for (int k = 0; k < 16; ++k) {
      const double a = edge.phi_from + (edge.phi_to - edge.phi_from) * k / 16.0;
      const double b = edge.phi_from + (edge.phi_to - edge.phi_from) * (k + 1) / 16.0;
      const double bound = ring.slope_bound(edge, a, b);
      for (int s = 0; s < 20; ++s) {
        const double p = a + (b - a) * s / 20.0;
        const double q = a + (b - a) * (s + 1) / 20.0;
        EXPECT_LE(std::abs((ring.at(edge, q).y - ring.at(edge, p).y) / (q - p)), bound * (1.0 + 1e-9));
      }
      EXPECT_LT(bound, 1.0);
    }
  }
}

TEST(Ring, WaysGoFromConfigurationToConfiguration) {
  const Ring ring{mechanism()};
  for (int from = 1; from <= 8; ++from)
    for (int to = 1; to <= 8; ++to)
      for (const RingWay way : {RingWay::kUp, RingWay::kDown}) {
        const std::vector<SlotPosture> points = way_along(ring, from, to, way, 5);
        EXPECT_EQ(points.size(), 5u * static_cast<std::size_t>(strokes(from, to, way)));
        if (points.empty()) continue;
        EXPECT_EQ(points.back().phi, ring.mechanism().configuration(to).phi);
        EXPECT_EQ(points.back().y, ring.mechanism().configuration(to).y);
      }
  EXPECT_EQ(strokes(1, 8, RingWay::kUp), 7);
  EXPECT_EQ(strokes(1, 8, RingWay::kDown), 1);
  EXPECT_EQ(shorter_way(1, 8), RingWay::kDown);
  EXPECT_EQ(shorter_way(7, 2), RingWay::kUp);
}

}  // namespace
}  // namespace foothold::xrobin
