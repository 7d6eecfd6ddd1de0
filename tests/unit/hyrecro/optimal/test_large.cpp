// Trusses so large that a good route is looked for instead of the best.
#include <random>

#include "climbing.hpp"
#include "hyrecro/optimal/bounds.hpp"
#include "hyrecro/scene/portals.hpp"
#include "hyrecro/scene/random_foothold.hpp"
#include "truss/generate.hpp"

namespace foothold::hyrecro {
namespace {

std::unique_ptr<PreparedTruss> generated(truss::Family family, std::uint64_t seed, int beams) {
  return prepared(truss::build(truss::generate(family, seed, beams)), false);
}

std::vector<Foothold> anywhere(const PreparedTruss& scene, std::uint64_t seed, int count) {
  std::mt19937_64 random(seed);
  std::vector<Foothold> out;
  for (int k = 0; k < count; ++k) out.push_back(random_foothold(robot(), scene.truss, random).value());
  return out;
}

Found plan(const PreparedTruss& scene, const Foothold& from, const Foothold& to, const std::stop_token& stop = {}) {
  return plan_optimal(robot(), scene, from, to, OptimalOptions{}, stop, {});
}

class Large : public testing::TestWithParam<truss::Family> {};

TEST_P(Large, RoutesOverTwoHundredBeamsCanBeClimbed) {
  const auto scene = generated(GetParam(), 3, 200);
  ASSERT_GT(scene->transitions.all().size(), kLarge);
  const std::vector<Foothold> at = anywhere(*scene, 8, 4);
  for (std::size_t k = 1; k < at.size(); ++k) {
    const Found found = plan(*scene, at[k - 1], at[k]);
    ASSERT_EQ(found.outcome, Found::Outcome::kReached) << found.failure.message;
    expect_climbable(*scene, found.route);
    EXPECT_TRUE(same(found.route.strides.back().to, at[k]));
    EXPECT_EQ(found.cost, static_cast<double>(found.route.strides.size()));
    const double apart = (pose_of(scene->truss, at[k]).translation() - pose_of(scene->truss, at[k - 1]).translation()).norm();
    EXPECT_GE(found.lower_bound * StrideBounds(robot()).transition_reach(), apart - 1e-9);
    EXPECT_LE(found.lower_bound, found.cost);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Large, testing::Values(truss::Family::kPortal, truss::Family::kTower, truss::Family::kBridge));

TEST(LargeTruss, AnswersTheSameWhateverWasAskedBefore) {
  const auto fresh = generated(truss::Family::kTower, 3, 200), used = generated(truss::Family::kTower, 3, 200);
  const std::vector<Foothold> at = anywhere(*fresh, 8, 4);
  for (std::size_t k = 1; k + 1 < at.size(); ++k) plan(*used, at[k], at[k + 1]);
  const Found one = plan(*fresh, at[0], at[1]), two = plan(*used, at[0], at[1]);
  ASSERT_EQ(one.outcome, Found::Outcome::kReached);
  ASSERT_EQ(one.route.strides.size(), two.route.strides.size());
  for (std::size_t k = 0; k < one.route.strides.size(); ++k) {
    EXPECT_TRUE(same(one.route.strides[k].to, two.route.strides[k].to));
    EXPECT_EQ(one.route.strides[k].coordinates.hip, two.route.strides[k].coordinates.hip);
  }
}

TEST(LargeTruss, StopsWhenAsked) {
  const auto scene = generated(truss::Family::kTower, 3, 200);
  const std::vector<Foothold> at = anywhere(*scene, 8, 2);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(plan(*scene, at[0], at[1], stop.get_token()).outcome, Found::Outcome::kStopped);
}

TEST(LargeTruss, CellsLeadToEachOtherBothWaysAndHoldEveryFootholdOnce) {
  const auto scene = generated(truss::Family::kBridge, 4, 60);
  const Portals portals(scene->transitions, scene->truss.faces.size());
  std::vector<int> times(scene->transitions.all().size(), 0);
  const auto leads = [&](int from, int to) {
    const auto edges = portals.edges(from);
    return std::any_of(edges.begin(), edges.end(), [&](const Portals::Edge& edge) { return edge.to == to; });
  };
  for (int cell = 0; cell < portals.cells(); ++cell) {
    for (const int k : portals.footholds(cell)) {
      ++times[static_cast<std::size_t>(k)];
      EXPECT_EQ(scene->transitions.all()[static_cast<std::size_t>(k)].foothold.face, portals.face_of(cell));
    }
    for (const Portals::Edge& edge : portals.edges(cell)) {
      EXPECT_TRUE(leads(edge.to, cell));
      EXPECT_EQ(edge.leg, portals.face_of(cell) == portals.face_of(edge.to));
      for (const auto& [a, b] : portals.opposite(cell, edge.to)) {
        const auto &one = scene->transitions.all()[static_cast<std::size_t>(a)],
                   &other = scene->transitions.all()[static_cast<std::size_t>(b)];
        EXPECT_EQ(one.towards, other.foothold.face);
        EXPECT_EQ(other.towards, one.foothold.face);
      }
    }
  }
  EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(times.size()));
}

}  // namespace
}  // namespace foothold::hyrecro
