// The planar workspace: its solutions hold, its entries are those of `exact`, its measures those of the closed form.
#include <gtest/gtest.h>

#include <map>

#include "hyrecro/motion/lift.hpp"
#include "hyrecro/reach/exact.hpp"
#include "hyrecro/reach/planar_workspace.hpp"
#include "poses.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kClearance = 0.005;
constexpr double kDegree = std::numbers::pi / 180.0;

const PlanarWorkspace& workspace(double position_step = 0.01, double heading_degrees = 5.0) {
  static std::map<std::pair<double, double>, PlanarWorkspace> made;
  const std::pair key(position_step, heading_degrees);
  auto at = made.find(key);
  if (at == made.end())
    at = made.emplace(key, *PlanarWorkspace::make(robot(), position_step, heading_degrees * kDegree, kClearance)).first;
  return at->second;
}

Isometry3d pose_at(const PlanarWorkspace& w, int i, int j, int k) {
  return to_isometry({i * w.position_step(), j * w.position_step(), k * w.heading_step()});
}

bool holds(const Isometry3d& pose, const Coordinates& c) {
  return within_limits(robot(), c) && difference(forward(robot(), c), pose) < 1e-9 &&
         free_of_itself(bodies_at(robot(), c, Isometry3d::Identity()), kClearance);
}

// Of the box round all bodies, in the frame of the sole that holds.
double bounding_volume(const Coordinates& c) {
  const Bodies bodies = bodies_at(robot(), c, Isometry3d::Identity());
  Eigen::AlignedBox3d box;
  for (const collision::Box* part : {&bodies.plate[0], &bodies.plate[1], &bodies.hip})
    for (int corner = 0; corner < 8; ++corner)
      box.extend(part->pose * Vector3d((corner & 1 ? 1 : -1) * part->half.x(), (corner & 2 ? 1 : -1) * part->half.y(),
                                       (corner & 4 ? 1 : -1) * part->half.z()));
  for (const collision::Capsule& leg : bodies.leg)
    for (const Vector3d& end : {leg.a, leg.b}) {
      box.extend(end - Vector3d::Constant(leg.radius));
      box.extend(end + Vector3d::Constant(leg.radius));
    }
  return box.volume();
}

struct Place {
  int i, j, k;
};
Place random_place(const PlanarWorkspace& w, std::mt19937_64& random) {
  const auto any = [&](int low, int high) { return std::uniform_int_distribution<>(low, high)(random); };
  return {any(-w.extent(), w.extent()), any(-w.extent(), w.extent()), any(0, w.headings() - 1)};
}

TEST(PlanarPose, IsSeenFromAnotherLikeItsIsometry) {
  std::mt19937_64 random(61);
  for (int i = 0; i < 1000; ++i) {
    const auto some = [&] { return PlanarPose{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -4, 4)}; };
    const PlanarPose a = some(), b = some();
    EXPECT_LT(difference(to_isometry(seen_from(a, b)), to_isometry(a).inverse() * to_isometry(b)), 1e-12);
  }
}

class WorkspaceBySteps : public ::testing::TestWithParam<std::pair<double, double>> {};

TEST_P(WorkspaceBySteps, EverySolutionHolds) {
  const PlanarWorkspace& w = workspace(GetParam().first, GetParam().second);
  int poses = 0;
  for (const PlanarWorkspace::Cell& cell : w.cells()) {
    int count = 0;
    for (int k = 0; k < w.headings(); ++k) {
      if (!w.reachable(cell.i, cell.j, k)) continue;
      ++count;
      ASSERT_TRUE(holds(pose_at(w, cell.i, cell.j, k), w.conservative(cell.i, cell.j, k))) << cell.i << ' ' << cell.j << ' ' << k;
    }
    ASSERT_EQ(count, cell.count);
    poses += count;
  }
  EXPECT_GT(poses, 1000);
}

// 8 deg and 24 deg have no half turn on the grid.
INSTANTIATE_TEST_SUITE_P(Steps, WorkspaceBySteps,
                         ::testing::Values(std::pair{0.03, 5.0}, std::pair{0.05, 2.0}, std::pair{0.02, 10.0}, std::pair{0.03, 20.0},
                                           std::pair{0.03, 8.0}, std::pair{0.05, 24.0}));

TEST(PlanarWorkspace, IsWhatExactSays) {
  const PlanarWorkspace& w = workspace();
  std::mt19937_64 random(62);
  Exact exact(robot(), kClearance);
  int both = 0, neither = 0, differ = 0;
  const int cells = long_tests() ? 50'000 : 6'000;
  for (int n = 0; n < cells; ++n) {
    const auto [i, j, k] = random_place(w, random);
    const bool in_table = w.reachable(i, j, k), by_exact = exact.reach(pose_at(w, i, j, k), {}).reachable;
    ++(in_table == by_exact ? (in_table ? both : neither) : differ);
  }
  RecordProperty("differ", differ);
  EXPECT_GT(both, cells / 5);
  EXPECT_GT(neither, cells / 5);
  EXPECT_LE(differ, cells / 2000);
}

TEST(PlanarWorkspace, IsTheSameSeenFromTheOtherFoot) {
  // Only quarter turns take grid points to grid points.
  const PlanarWorkspace& w = workspace();
  int reached = 0, differ = 0;
  for (int i = -w.extent(); i <= w.extent(); ++i)
    for (int j = -w.extent(); j <= w.extent(); ++j)
      for (int quarter = 0; quarter < 4; ++quarter) {
        const int k = quarter * w.headings() / 4, back = (w.headings() - k) % w.headings();
        const int cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};
        const int x = -(cosine[quarter] * i + sine[quarter] * j), y = sine[quarter] * i - cosine[quarter] * j;
        reached += w.reachable(i, j, k) ? 1 : 0;
        differ += w.reachable(i, j, k) != w.reachable(x, y, back) ? 1 : 0;
      }
  EXPECT_GT(reached, 5000);
  EXPECT_LE(differ, reached / 1000);
}

TEST(PlanarWorkspace, ConservativeSolutionsFillTheLargestBox) {
  const PlanarWorkspace& w = workspace();
  std::mt19937_64 random(63);
  Exact exact(robot(), kClearance);
  int poses = 0;
  double sum = 0.0;
  while (poses < 150) {
    const auto [i, j, k] = random_place(w, random);
    if (!w.reachable(i, j, k) || 2 * k % w.headings() == 0) continue;
    ++poses;
    const double widest = bounding_volume(w.conservative(i, j, k));
    double found = 0.0;
    exact.for_each_solution(pose_at(w, i, j, k), [&](const Coordinates& c) {
      found = std::fmax(found, bounding_volume(c));
      return false;
    });
    EXPECT_LT(found, 1.03 * widest);
    sum += found / widest;
  }
  EXPECT_GT(sum, 0.8 * poses);
}

TEST(PlanarWorkspace, LongestReachIsThatOfBothLegsAtTheirGreatestShift) {
  const auto& mechanism = robot().mechanism;
  double shift = 0.0;
  for (int i = 0; i <= 20000; ++i) {
    const double phi = mechanism.greatest_phi() * i / 20000.0;
    shift = std::fmax(shift, (2.0 * mechanism.offsets(phi).high - robot().core) * std::sin(phi));
  }
  const double reach = 2.0 * shift + robot().hip_distance;
  EXPECT_NEAR(PlanarPostures(robot(), kClearance).greatest_shift(), shift, 1e-6);
  for (const double step : {0.01, 0.02, 0.03, 0.05}) {
    const double r_max = workspace(step, step == 0.01 ? 5.0 : 20.0).r_max();
    EXPECT_LE(r_max, reach);
    EXPECT_GT(r_max, reach - step - 0.002);
  }
}

TEST(PlanarWorkspace, EveryHeadingIsReachableAheadAndBehindAroundTheBestReach) {
  for (const double step : {0.01, 0.02, 0.03, 0.05}) {
    const PlanarWorkspace& w = workspace(step, step == 0.01 ? 5.0 : 20.0);
    EXPECT_NEAR(w.r_opt(), workspace().r_opt(), 0.01);
    const int nearest = static_cast<int>(std::lround(w.r_opt() / step)), around = static_cast<int>(0.06 / step);
    for (int i = nearest - around; i <= nearest + around; ++i)
      for (int k = 0; k < w.headings(); ++k) EXPECT_TRUE(w.reachable(i, 0, k) && w.reachable(-i, 0, k)) << step << ' ' << i;
  }
}

TEST(PlanarWorkspace, OfPosturesWithRoomToLiftHoldsThreeFifthsOfThePoses) {
  constexpr double kLift = 0.022;  // m
  const PlanarWorkspace& all = workspace();
  const auto some = PlanarWorkspace::make(robot(), 0.01, 5.0 * kDegree, kClearance, {},
                                          [](const Coordinates& c) { return legs_lift(robot(), c, kLift); });
  ASSERT_TRUE(some);
  std::size_t reachable = 0, liftable = 0;
  for (const PlanarWorkspace::Cell& cell : all.cells())
    for (int k = 0; k < all.headings(); ++k) {
      reachable += all.reachable(cell.i, cell.j, k) ? 1 : 0;
      if (!some->reachable(cell.i, cell.j, k)) continue;
      ++liftable;
      ASSERT_TRUE(all.reachable(cell.i, cell.j, k));
      const Coordinates c = some->conservative(cell.i, cell.j, k);
      ASSERT_TRUE(holds(pose_at(*some, cell.i, cell.j, k), c));
      // Either foot along its normal, the other one staying where it is.
      for (const Coordinates& seen : {c, swapped(c)}) {
        const auto up = lifted(robot(), seen, kLift);
        ASSERT_TRUE(up && within_limits(robot(), *up));
        ASSERT_LT(difference(forward(robot(), seen) * Eigen::Translation3d(0.0, 0.0, kLift), forward(robot(), *up)), 1e-9);
      }
    }
  EXPECT_LT(liftable, reachable);
  EXPECT_GT(static_cast<double>(liftable), 0.6 * static_cast<double>(reachable));
  EXPECT_LT(some->r_max(), all.r_max());
  EXPECT_GT(some->r_max(), 0.85 * all.r_max());
}

TEST(PlanarWorkspace, StopsWhenAskedTo) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(PlanarWorkspace::make(robot(), 0.01, 5.0 * kDegree, kClearance, stop.get_token()));
}

}  // namespace
}  // namespace foothold::hyrecro
