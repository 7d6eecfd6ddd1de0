// Bounds of strides against random chains of postures, and against what is reached.
#include "hyrecro/optimal/bounds.hpp"

#include <gtest/gtest.h>

#include "hyrecro/optimal/level_postures.hpp"
#include "hyrecro/optimal/narrow.hpp"
#include "poses.hpp"

namespace foothold::hyrecro {
namespace {

double heading_of(const Isometry3d& pose) { return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)); }

Foothold after(const Foothold& from, const Isometry3d& stride) {
  const Eigen::Vector2d there = stride.translation().head<2>();
  return {from.face, from.at + Eigen::Rotation2Dd(from.heading) * there, from.heading + heading_of(stride)};
}

// Both soles in one plane with both legs leaning: heading difference 0 or pi, psi drawn, the second leg solved for the height.
std::optional<Isometry3d> leaning(std::mt19937_64& random) {
  const Model& model = robot();
  const double most = model.mechanism.greatest_phi(), psi = uniform(random, -most, most), side = random() % 2 == 0 ? 1.0 : -1.0;
  Coordinates c;
  const auto leg = [&](Leg& out, double lean) {
    out.phi1 = uniform(random, std::max(-most, lean - most), std::min(most, lean + most));
    out.phi2 = lean - out.phi1;
    const auto y1 = model.mechanism.offsets(out.phi1), y2 = model.mechanism.offsets(out.phi2);
    if (y1.empty() || y2.empty()) return false;
    out.y1 = random() % 3 == 0 ? y1.high : uniform(random, y1.low, y1.high);
    out.y2 = random() % 3 == 0 ? y2.high : uniform(random, y2.low, y2.high);
    return true;
  };
  if (!leg(c.leg[0], psi) || !leg(c.leg[1], side * psi)) return std::nullopt;
  // Height of sole 1 over sole 0's plane must be 0: the hip's swing takes up the rest, t cos(hip0) sin(psi).
  const auto height = [&](const Leg& l) { return leg_length(model, l) * std::cos(l.phi1) + model.hip_drop * std::cos(psi); };
  const double cosine = (height(c.leg[1]) - height(c.leg[0])) / (model.hip_distance * std::sin(psi));
  if (!(std::fabs(cosine) <= 1.0)) return std::nullopt;
  c.hip[0] = (random() % 2 == 0 ? 1.0 : -1.0) * std::acos(cosine);
  c.hip[1] = c.hip[0] - (side > 0.0 ? 0.0 : std::numbers::pi);
  const Isometry3d pose = forward(model, c);
  if (std::fabs(pose.translation().z()) > 1e-9) return std::nullopt;
  return pose;
}

TEST(StrideBounds, NoChainOfPosturesTakesFewerStrides) {
  const StrideBounds bounds(robot());
  std::mt19937_64 random(11);
  int leant = 0;
  for (int chain = 0; chain < 200'000; ++chain) {
    const Foothold start{0, {uniform(random, -1, 1), uniform(random, -1, 1)}, uniform(random, -4, 4)};
    Foothold at = start;
    const int count = 1 + static_cast<int>(random() % 4);
    for (int i = 0; i < count; ++i) {
      if (const auto lean = random() % 2 == 0 ? leaning(random) : std::nullopt) {
        ++leant;
        at = after(at, *lean);
      } else {
        at = after(at, random_reached_pose(random, Kind::kPlanar));
      }
    }
    ASSERT_LE(bounds.least(start, at), count) << "chain " << chain;
  }
  EXPECT_GT(leant, 1000);
}

TEST(StrideBounds, TheLongestChainsMeetTheBound) {
  const StrideBounds bounds(robot());
  const double reach = bounds.reach();
  EXPECT_GT(reach, 0.5);
  const auto along = [](double x) { return Foothold{0, {x, 0.0}, 0.0}; };
  for (int count = 1; count < 6; ++count) {
    EXPECT_EQ(bounds.least(along(0.0), along(count * reach - 1e-6)), count);
    EXPECT_EQ(bounds.least(along(0.0), along(count * reach + 1e-6)), count + 1);
  }
  // Across the way a heading gives no shift.
  const Foothold across{0, {0.0, 0.0}, 0.5 * std::numbers::pi};
  EXPECT_EQ(bounds.least(across, along(reach - bounds.shift() + 2e-3)), 2);
}

TEST(StrideBounds, KeepTheTriangleInequality) {
  const StrideBounds bounds(robot());
  std::mt19937_64 random(12);
  const auto some = [&] { return Foothold{0, {uniform(random, -2, 2), uniform(random, -2, 2)}, uniform(random, -4, 4)}; };
  for (int i = 0; i < 100'000; ++i) {
    const Foothold a = some(), b = some(), c = some();
    ASSERT_EQ(bounds.least(a, b), bounds.least(b, a));
    ASSERT_LE(bounds.least(a, c), bounds.least(a, b) + bounds.least(b, c));
  }
}

// The legs of an upright posture: leg 0 leans by `phi0` and is `share` of the way out, the other one leans as far as it can at that
// height.
std::optional<Coordinates> stretched(double phi0, double share) {
  const Model& model = robot();
  const auto y = model.mechanism.offsets(phi0);
  if (y.empty()) return std::nullopt;
  Coordinates c;
  const double each = y.low + share * (y.high - y.low), height = (2.0 * each - model.core) * std::cos(phi0);
  c.leg[0] = {phi0, each, -phi0, each};
  for (double phi1 = model.mechanism.greatest_phi(); phi1 >= 0.0; phi1 -= 2e-3) {
    const auto other = model.mechanism.offsets(phi1);
    const double half = 0.5 * (height / std::cos(phi1) + model.core);
    if (other.empty() || !other.holds(half)) continue;
    c.leg[1] = {phi1, half, -phi1, half};
    return c;
  }
  return std::nullopt;
}

// The hip's line goes to `to` and sole 1 heads to `heading`, both seen from sole 0.
Isometry3d headed(Coordinates c, double to, double heading) {
  c.hip = {to, to - heading};
  return forward(robot(), c);
}

TEST(StrideBounds, NothingAdvancesFurtherAlongAStripAndSomethingNearlyAsFar) {
  const StrideBounds bounds(robot());
  std::mt19937_64 random(14);
  for (int i = 0; i < 24; ++i) {
    const double heading = i % 3 == 0 ? 0.5 * std::numbers::pi * (i % 4) : uniform(random, -4, 4);
    const double low = uniform(random, -0.12, 0.0), high = uniform(random, 0.0, 0.12);
    const double bound = bounds.advance(direction(heading), low, high);
    EXPECT_LE(bound, bounds.reach());
    double furthest = 0.0;
    for (double phi0 = -0.86; phi0 < 0.86; phi0 += 0.02)
      for (double share = 0.0; share <= 1.0; share += 0.125)
        if (const auto legs = stretched(phi0, share))
          for (double to = -1.5; to < 1.5; to += 0.02) {
            // A positive phi takes leg 1's pin back: its sole is in front.
            const Isometry3d pose = headed(*legs, to - heading, to - heading);
            const Vector2d at = Eigen::Rotation2Dd(heading) * pose.translation().head<2>();
            if (at.y() >= low && at.y() <= high) furthest = std::max(furthest, at.x());
          }
    EXPECT_LE(furthest, bound) << "heading " << heading << ", strip " << low << " to " << high;
    EXPECT_GT(furthest, bound - 0.008) << "heading " << heading << ", strip " << low << " to " << high;
  }
}

TEST(StrideBounds, NoChainInAStripTakesFewerStrides) {
  const StrideBounds bounds(robot());
  std::mt19937_64 random(15);
  int tight = 0;
  for (int chain = 0; chain < 3'000; ++chain) {
    const double half = uniform(random, 0.005, 0.15), turn = uniform(random, -4, 4);
    const Strip strip{direction(turn), -half, half};
    // Headings mostly along and across, as those are that reach far or stand at an edge.
    const auto heading = [&] {
      return random() % 2 == 0 ? uniform(random, -4, 4) : turn + 0.5 * std::numbers::pi * static_cast<double>(random() % 4);
    };
    const Foothold start{0, uniform(random, -half, half) * Vector2d(-strip.along.y(), strip.along.x()), heading()};
    Foothold at = start;
    const int count = 1 + static_cast<int>(random() % 4);
    int done = 0;
    for (int tries = 0; done < count && tries < 200; ++tries) {
      const double share = random() % 2 == 0 ? 0.0 : uniform(random, 0, 1), next_heading = heading();
      const double to = turn + uniform(random, -0.5, 0.5) - at.heading;
      std::optional<Isometry3d> stride;
      if (random() % 8 == 0)
        stride = leaning(random);
      else if (const auto legs = stretched(uniform(random, -0.85, 0.85), share))
        stride = headed(*legs, to, next_heading - at.heading);
      if (!stride) continue;
      const Foothold next = after(at, *stride);
      if (std::fabs(strip.across(next.at)) > half || strip.along.dot(next.at - at.at) < 0.35) continue;
      at = next;
      ++done;
    }
    if (done < count) continue;
    const double way = strip.along.dot(at.at - start.at);
    const int least = bounds.least_along(way, advances(bounds, strip, start).forth, advances(bounds, strip, at).back);
    ASSERT_LE(least, count) << "chain " << chain;
    tight += least == count ? 1 : 0;
  }
  EXPECT_GT(tight, 500);
}

TEST(StrideBounds, KeepTheTriangleInequalityAlongAStrip) {
  const StrideBounds bounds(robot());
  std::mt19937_64 random(16);
  for (int i = 0; i < 20'000; ++i) {
    const double half = uniform(random, 0.005, 0.15);
    const Strip strip{{1.0, 0.0}, -half, half};
    const auto some = [&] { return Foothold{0, {uniform(random, -1, 1), uniform(random, -half, half)}, uniform(random, -4, 4)}; };
    const auto least = [&](const Foothold& a, const Foothold& b) {
      const Foothold &from = a.at.x() < b.at.x() ? a : b, &to = a.at.x() < b.at.x() ? b : a;
      return bounds.least_along(to.at.x() - from.at.x(), advances(bounds, strip, from).forth, advances(bounds, strip, to).back);
    };
    const Foothold a = some(), b = some(), c = some();
    ASSERT_LE(least(a, c), least(a, b) + least(b, c));
  }
}

// Against postures by the dense: every foothold between that a lattice holds, with the strides to it and from it in closed form.
TEST(Narrow, TwoStridesAreRuledOutOnlyWhereALatticeHoldsNone) {
  const StrideBounds bounds(robot());
  const LevelPostures postures(robot(), bounds.shift());
  const Vector2d plate = robot().plate.head<2>();
  std::mt19937_64 random(17);
  int ruled_out = 0, done = 0, possible = 0;
  for (int i = 0; i < 100; ++i) {
    const double half = uniform(random, 0.06, 0.15);
    const Strip strip{{1.0, 0.0}, 0.05 - half, half - 0.05, 0.05};
    const auto end = [&](double x) {
      const double heading =
          random() % 2 == 0 ? 0.5 * std::numbers::pi * static_cast<double>(random() % 4) : uniform(random, -4, 4);
      return Foothold{0, {x, uniform(random, strip.low, strip.high)}, heading};
    };
    const Foothold u = end(0.0);
    Foothold v = end(0.0);
    // About as far as the quick bound lets two strides lead.
    v.at.x() = advances(bounds, strip, u).forth + advances(bounds, strip, v).back - uniform(random, 0.0, 0.03);
    const bool may = two_may_do(bounds, strip, plate, u, v);
    EXPECT_LE(furthest(bounds, strip, plate, u, 1.0), bounds.reach());
    (may ? possible : ruled_out) += 1;
    const auto leads = [&](const Foothold& from, const Foothold& to) {
      return postures.any(Eigen::Rotation2Dd(-from.heading) * (to.at - from.at), to.heading - from.heading,
                          [](const Coordinates&) { return true; });
    };
    bool exists = false;
    const double last = advances(bounds, strip, v).back;
    for (double heading = 0.0; heading < 3.14 && !exists; heading += std::numbers::pi / 36)
      for (double y = strip.low; y <= strip.high && !exists; y += 0.004)
        for (double x = v.at.x() - last; x <= advances(bounds, strip, u).forth && !exists; x += 0.004) {
          const Foothold m{0, {x, y}, heading};
          const double wide = 0.05 * (std::fabs(std::sin(heading)) + std::fabs(std::cos(heading)));
          if (std::fabs(y) > half - wide || !leads(u, m)) continue;
          exists = leads(m, v);
        }
    if (exists) {
      ++done;
      EXPECT_TRUE(may) << i;
    }
  }
  EXPECT_GT(ruled_out, 15);
  EXPECT_GT(done, 15);
  EXPECT_GT(done, possible / 2);
}

TEST(LevelPostures, PutTheFreeSoleWhereItShallBe) {
  const LevelPostures postures(robot(), StrideBounds(robot()).shift());
  std::mt19937_64 random(13);
  int reached = 0;
  constexpr int kPoses = 20'000;
  for (int i = 0; i < kPoses; ++i) {
    const Isometry3d pose = random_reached_pose(random, Kind::kPlanar);
    reached += postures.any(pose.translation().head<2>(), heading_of(pose), [&](const Coordinates& c) {
      EXPECT_LT(difference(forward(robot(), c), pose), 1e-9);
      EXPECT_TRUE(within_limits(robot(), c));
      return true;
    });
  }
  EXPECT_GT(reached, 0.95 * kPoses);
}

}  // namespace
}  // namespace foothold::hyrecro
