// Verdicts against CLP and exact arithmetic on random stances: 1,000,000 of them with FOOTHOLD_LONG=1, else 3,000.
//
// CLP judges every stance. cddlib, which is 3,000 times slower, judges those in exact arithmetic on which CLP and we differ, those
// within 1 % of the border of stability in mu, and every 40th beside them. Outside the band of 1e-9: the verdict is the same for w
// and for w +- 1e-9 along each of the six axes, in weights and weights x greatest distance; so for all in the cross-polytope of
// these.
#include <gtest/gtest.h>

#include <cstdlib>

#include "contact/certificate.hpp"
#include "oracles.hpp"
#include "stances.hpp"

namespace foothold::contact {
namespace {

constexpr int kEdges = 10;
constexpr double kBand = 1e-9, kNearBorder = 0.01;

int stances() { return std::getenv("FOOTHOLD_LONG") != nullptr ? 1'000'000 : 3'000; }

// The stance in units of its greatest distance.
Stance scaled(const Stance& s) {
  double most = 0.0;
  for (const Contact& c : s.contacts) most = std::max(most, (c.point - s.com).norm());
  Stance out{.contacts = s.contacts, .mu = s.mu};
  for (Contact& c : out.contacts) c.point = (c.point - s.com) / most;
  return out;
}

// Whether the exact verdict is the same for each w within `band` along an axis; `one_of_them` is that for w.
template <class Judge>
bool same_around(const Generators& columns, double band, bool one_of_them, Judge holds) {
  for (Eigen::Index k = 0; k < 6; ++k)
    for (const double sign : {-band, band})
      if (holds(columns, Wrench(Wrench::Unit(2) + sign * Wrench::Unit(k))) != one_of_them) return false;
  return true;
}

struct Tally {
  int stances = 0, stable = 0, exact = 0, in_band = 0, differ = 0, unproved = 0, refused = 0, near_border = 0;
};

void compare(const Stance& s, const Verdict& verdict, Clp& clp, bool sampled, Tally& tally) {
  ++tally.stances;
  tally.stable += verdict.stable ? 1 : 0;
  tally.unproved += verdict.proved ? 0 : 1;
  tally.refused += proves(verdict, s.contacts, s.com, s.mu, FrictionCone::pyramid(kEdges)) ? 0 : 1;
  const Generators columns = generators(scaled(s), kEdges);
  const Wrench w = Wrench::Unit(2);
  // A verdict that holds for mu a little less and a little more is not near the border: no need to ask CLP thirteen times.
  const bool differs = clp.holds(columns, w) != verdict.stable;
  Stance tighter = scaled(s);
  tighter.mu *= verdict.stable ? 1.0 - kNearBorder : 1.0 + kNearBorder;
  const bool near = clp.holds(generators(tighter, kEdges), w) != verdict.stable;
  tally.near_border += near ? 1 : 0;
  if (!differs && !near && !sampled) return;
  ++tally.exact;
  const bool truth = holds_exactly(columns, w);
  if (truth == verdict.stable) return;
  if (same_around(columns, kBand, truth, holds_exactly)) {
    ++tally.differ;
  } else {
    ++tally.in_band;
  }
}

TEST(EquilibriumAgainstOracles, NeverDiffersFromThemOutsideABandOfANanoweight) {
  std::mt19937_64 random(2023);
  Equilibrium equilibrium(FrictionCone::pyramid(kEdges));
  Clp clp;
  Tally tally;
  for (int i = 0; i < stances(); ++i) {
    const Stance s = random_stance(random);
    equilibrium.forget();
    compare(s, equilibrium.judge(s.contacts, s.com, s.mu), clp, i % 40 == 0, tally);
  }
  RecordProperty("stable", tally.stable);
  RecordProperty("exact", tally.exact);
  RecordProperty("near_border", tally.near_border);
  RecordProperty("in_band", tally.in_band);
  EXPECT_EQ(tally.differ, 0);
  EXPECT_EQ(tally.unproved, 0);
  EXPECT_EQ(tally.refused, 0);
  EXPECT_GT(tally.stable, tally.stances / 4);
  EXPECT_LT(tally.stable, tally.stances * 3 / 4);
  EXPECT_GT(tally.exact, tally.stances / 40);
}

TEST(EquilibriumAgainstOracles, NeverDiffersFromThemFromAWarmStart) {
  std::mt19937_64 random(2024);
  Equilibrium equilibrium(FrictionCone::pyramid(kEdges));
  Clp clp;
  Tally tally;
  Stance s = random_stance(random);
  for (int i = 0; i < stances() / 10; ++i) {
    s = i % 20 == 0 ? random_stance(random) : neighbour(random, s, 0.01);
    compare(s, equilibrium.judge(s.contacts, s.com, s.mu), clp, i % 40 == 0, tally);
  }
  EXPECT_EQ(tally.differ, 0);
  EXPECT_EQ(tally.unproved, 0);
  EXPECT_EQ(tally.refused, 0);
}

// Stances moved to where the verdict turns, by halving the range of mu: 1e-12 on either side of it and beyond.
TEST(EquilibriumAgainstOracles, IsRightAtTheBorderOfStability) {
  std::mt19937_64 random(2025);
  Equilibrium equilibrium(FrictionCone::pyramid(kEdges));
  int differ = 0, refused = 0, borders = 0;
  for (int i = 0; i < stances() / 100; ++i) {
    Stance s = random_stance(random);
    double low = 0.0, high = 2.0;
    const auto holds = [&](double mu) { return equilibrium.judge(s.contacts, s.com, mu).stable; };
    if (holds(low) || !holds(high)) continue;
    ++borders;
    while (high - low > 1e-12) (holds(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    for (const double off : {-1e-6, -1e-8, -1e-10, 0.0, 1e-10, 1e-8, 1e-6}) {
      s.mu = high + off;
      const Verdict& verdict = equilibrium.judge(s.contacts, s.com, s.mu);
      refused += proves(verdict, s.contacts, s.com, s.mu, equilibrium.cone()) ? 0 : 1;
      const Generators columns = generators(scaled(s), kEdges);
      const bool truth = holds_exactly(columns, Wrench::Unit(2));
      if (truth != verdict.stable && same_around(columns, kBand, truth, holds_exactly)) ++differ;
    }
  }
  EXPECT_GT(borders, stances() / 1000);
  EXPECT_EQ(differ, 0);
  EXPECT_EQ(refused, 0);
}

}  // namespace
}  // namespace foothold::contact
