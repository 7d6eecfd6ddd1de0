// `exact` against random search with many tries, and what its positives promise.
#include <gtest/gtest.h>

#include "hyrecro/reach/exact.hpp"
#include "hyrecro/reach/inverse.hpp"
#include "poses.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kClearance = 0.005;

// Within limits, closing, free of itself: by the chain and the bodies alone.
bool holds(const Isometry3d& pose, const Coordinates& c, double closure = 1e-9) {
  return within_limits(robot(), c) && difference(forward(robot(), c), pose) < closure &&
         free_of_itself(bodies_at(robot(), c, Isometry3d::Identity()), kClearance);
}

struct Tally {
  int both = 0, neither = 0, only_exact = 0, only_random = 0, wrong = 0;
};

Tally compare(Kind kind, int poses, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto exact = make_exact(robot(), kClearance);
  const auto iterative = make_iterative(robot(), kClearance, 10'000, random);
  Tally out;
  for (int i = 0; i < poses; ++i) {
    const Isometry3d pose = i % 4 == 3 ? random_reached_pose(random, kind) : random_pose(random, kind);
    const Reach one = exact->reach(pose, {}), two = iterative->reach(pose, {});
    if (one.reachable && (!one.coordinates || !holds(pose, *one.coordinates))) ++out.wrong;
    ++(one.reachable ? (two.reachable ? out.both : out.only_exact) : (two.reachable ? out.only_random : out.neither));
  }
  return out;
}

class ExactByKind : public ::testing::TestWithParam<Kind> {};

TEST_P(ExactByKind, FindsWhatRandomSearchFinds) {
  const int poses = long_tests() ? 2'500 : 250;
  const Tally tally = compare(GetParam(), poses, 41 + static_cast<std::uint64_t>(GetParam()));
  RecordProperty("both", tally.both);
  RecordProperty("only_exact", tally.only_exact);
  RecordProperty("only_random", tally.only_random);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_LE(tally.only_random, poses / 1000);
  EXPECT_GT(tally.both, poses / 10);
  EXPECT_GT(tally.neither, poses / 10);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ExactByKind, ::testing::ValuesIn(kKinds));

// Why transition footholds need one heading alone.
TEST_P(ExactByKind, AFootThatIsTurnedRoundReachesTheSame) {
  std::mt19937_64 random(61 + static_cast<std::uint64_t>(GetParam()));
  const auto exact = make_exact(robot(), kClearance);
  const Eigen::AngleAxisd round(std::numbers::pi, Vector3d::UnitZ());
  int reached = 0;
  for (int i = 0; i < 400; ++i) {
    const Isometry3d pose = i % 2 == 0 ? random_reached_pose(random, GetParam()) : random_pose(random, GetParam());
    const Reach straight = exact->reach(pose, {});
    if (!straight.reachable) continue;
    ++reached;
    for (const Isometry3d& turned : {pose * round, round * pose, round * pose * round})
      EXPECT_TRUE(exact->reach(turned, {}).reachable) << "pose " << i;
  }
  EXPECT_GT(reached, 100);
}

// A reachable pose of each kind, in turn.
Isometry3d reachable_pose(std::mt19937_64& random, Exact& exact, Kind kind) {
  for (;;) {
    const Isometry3d pose = random_reached_pose(random, kind);
    if (exact.reach(pose, {}).reachable) return pose;
  }
}

double apart(const Coordinates& a, const Coordinates& b) {
  double most = 0.0;
  for (std::size_t j = 0; j < 2; ++j)
    for (const double d : {a.leg[j].phi1 - b.leg[j].phi1, a.leg[j].phi2 - b.leg[j].phi2,
                           leg_length(robot(), a.leg[j]) - leg_length(robot(), b.leg[j]),
                           std::remainder(a.hip[j] - b.hip[j], 2.0 * std::numbers::pi)})
      most = std::fmax(most, std::fabs(d));
  return most;
}

TEST(Exact, AnswersTheSameWhateverItWasAskedBefore) {
  std::mt19937_64 random(51);
  Exact used(robot(), kClearance);
  for (int i = 0; i < 200; ++i) {
    const Isometry3d pose = random_reached_pose(random, kKinds[i % 4]);
    Exact fresh(robot(), kClearance);
    const Reach one = used.reach(pose, {}), two = fresh.reach(pose, {});
    ASSERT_EQ(one.reachable, two.reachable);
    if (one.reachable) {
      EXPECT_EQ(apart(*one.coordinates, *two.coordinates), 0.0);
    }
  }
}

TEST(Exact, OffersDifferentSolutionsAndAllOfThemHold) {
  std::mt19937_64 random(52);
  Exact exact(robot(), kClearance);
  for (int i = 0; i < 40; ++i) {
    const Isometry3d pose = reachable_pose(random, exact, kKinds[i % 4]);
    std::vector<Coordinates> offered;
    const bool taken = exact.for_each_solution(pose, [&](const Coordinates& c) {
      EXPECT_TRUE(holds(pose, c));
      offered.push_back(c);
      return offered.size() == 60;
    });
    EXPECT_EQ(taken, offered.size() == 60);
    for (std::size_t a = 0; a < offered.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) EXPECT_GT(apart(offered[a], offered[b]), 1e-6);
  }
}

TEST(Exact, GivesOnlyWhatIsAdmitted) {
  std::mt19937_64 random(53);
  Exact exact(robot(), kClearance);
  int turned_away = 0;
  for (int i = 0; i < 40; ++i) {
    const Isometry3d pose = reachable_pose(random, exact, kKinds[i % 4]);
    const Coordinates first = *exact.reach(pose, {}).coordinates;
    EXPECT_FALSE(exact.reach(pose, [](const Coordinates&) { return false; }).reachable);
    // The hip on the other side than in the first answer, which not every pose allows.
    const auto other_side = [&](const Coordinates& c) { return std::cos(c.hip[0]) * std::cos(first.hip[0]) < 0.0; };
    const Reach other = exact.reach(pose, other_side);
    if (other.reachable) {
      EXPECT_TRUE(other_side(*other.coordinates));
      ++turned_away;
    }
  }
  EXPECT_GT(turned_away, 0);
}

TEST(Exact, OffersNoMoreThanItMay) {
  std::mt19937_64 random(54);
  CellSearchOptions few;
  few.most_offers = 5;
  Exact exact(robot(), kClearance, few);
  for (int i = 0; i < 40; ++i) {
    int offers = 0;
    exact.for_each_solution(random_reached_pose(random, kKinds[i % 4]), [&](const Coordinates&) { return ++offers, false; });
    EXPECT_LE(offers, 5);
  }
}

TEST(Exact, ToleratesTheRoundingOfSingularPoses) {
  std::mt19937_64 random(55);
  Exact exact(robot(), kClearance);
  int reached = 0;
  for (int i = 0; i < 300; ++i) {
    const Isometry3d pose = reachable_pose(random, exact, Kind::kTransition);
    const Vector3d axis = in_sphere(random, 1.0).normalized();
    for (const double tilt : {1e-12, 1e-9, 5e-8}) {
      const Isometry3d off = pose * turned(tilt, axis);
      const Reach found = exact.reach(off, {});
      if (!found.reachable) continue;
      ++reached;
      EXPECT_TRUE(holds(off, *found.coordinates, 1.5e-7));
    }
  }
  EXPECT_GT(reached, 890);
}

// Straight over an edge and straight into a corner, at the distances from the edge that the paper uses. Aside, the hip must reach
// across: over an edge at least as far as random search says, into a corner up to its length.
TEST(Exact, ReachesThePapersTransitions) {
  Exact exact(robot(), kClearance);
  const auto sole = [](const Vector3d& at, const Vector3d& x, const Vector3d& z) {
    Isometry3d out = Isometry3d::Identity();
    out.linear() << x, z.cross(x), z;
    out.translation() = at;
    return out;
  };
  const Vector3d x = Vector3d::UnitX(), z = Vector3d::UnitZ();
  std::mt19937_64 random(57);
  const auto iterative = make_iterative(robot(), kClearance, 10'000, random);
  for (int k = -15; k <= 15; ++k) {
    const double aside = 0.01 * k;
    for (const double heading : {1.0, -1.0}) {
      const Isometry3d convex = sole({0.07, aside, -0.07}, heading * z, x);
      EXPECT_GE(exact.reach(convex, {}).reachable, iterative->reach(convex, {}).reachable) << aside;
      if (std::abs(k) <= 10) {
        EXPECT_TRUE(exact.reach(convex, {}).reachable) << aside;
      }
      EXPECT_TRUE(exact.reach(sole({0.25, aside, 0.25}, heading * z, -x), {}).reachable) << "concave, " << aside;
    }
  }
  EXPECT_FALSE(exact.reach(sole({0.07, 0.16, -0.07}, z, x), {}).reachable);
  EXPECT_FALSE(exact.reach(sole({0.25, 0.16, 0.25}, z, -x), {}).reachable);
}

TEST(Iterative, GivesUpAfterItsTries) {
  std::mt19937_64 random(56), same(56);
  Exact exact(robot(), kClearance);
  const auto few = make_iterative(robot(), kClearance, 3, random), many = make_iterative(robot(), kClearance, 3'000, same);
  int by_few = 0, by_many = 0;
  for (int i = 0; i < 300; ++i) {
    const Isometry3d pose = reachable_pose(random, exact, kKinds[i % 4]);
    const Reach one = few->reach(pose, {}), two = many->reach(pose, {});
    by_few += one.reachable ? 1 : 0;
    by_many += two.reachable ? 1 : 0;
    if (two.reachable) {
      EXPECT_TRUE(holds(pose, *two.coordinates));
    }
  }
  EXPECT_LT(by_few, by_many);
  EXPECT_GT(by_many, 250);
}

}  // namespace
}  // namespace foothold::hyrecro
