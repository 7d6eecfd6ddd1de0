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
  const int poses = long_tests() ? 3'334 : 200;
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

}  // namespace
}  // namespace foothold::hyrecro
