// Ends to which hardly any stride leads: routes to them, looked at again; and how their postures are spread.
#include "climbing.hpp"
#include "hyrecro/optimal/gates.hpp"
#include "truss/generate.hpp"

namespace foothold::hyrecro {
namespace {

struct Hemmed {
  const char* why;
  truss::Family family;
  std::uint64_t seed;
  int beams;
  Foothold start, goal;
  bool own_face;  // the gates lie on the hemmed end's own face
  bool at_start;
};

const Foothold kUnderABeam{7, {-0.385161, -0.010272}, -0.460969};
const Foothold kOnAnEnd{10, {-0.028457, 0.026243}, 0.137017}, kAcrossAnEnd{11, {-0.051651, -0.000347}, 0.042193};
const Hemmed kHemmed[] = {
    {"GoalUnderABeam", truss::Family::kTower, 235, 4, {3, {-0.330530, -0.032875}, 0.411241}, kUnderABeam, true, false},
    {"StartOnABeamsEnd", truss::Family::kPortal, 276, 2, kOnAnEnd, {7, {-0.655349, 0.025950}, -1.513862}, true, true},
    {"StartAcrossABeamsEnd", truss::Family::kPortal, 726, 7, kAcrossAnEnd, {33, {0.100252, -0.044538}, -0.886459}, false, true}};

struct HemmedIn : testing::TestWithParam<Hemmed> {
  std::unique_ptr<PreparedTruss> scene =
      prepared(truss::build(truss::generate(GetParam().family, GetParam().seed, GetParam().beams)), false);
};

// Whatever a lattice of footholds would show: 10 cm and 45 degrees.
TEST_P(HemmedIn, NoStrideLeadsThereFromALatticeOfItsFaceNorFromATransitionFoothold) {
  const Hemmed& given = GetParam();
  const Foothold& end = given.at_start ? given.start : given.goal;
  Strides strides(robot(), *scene);
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j)
      for (int k = 0; k < 8; ++k) {
        const Foothold at{end.face, end.at + 0.1 * Vector2d(i, j), end.heading + k * std::numbers::pi / 4.0};
        if ((i == 0 && j == 0) || !strides.on_face(at)) continue;
        EXPECT_FALSE(strides.exact(end, at)) << i << ' ' << j << ' ' << k;
      }
  for (const int near : scene->transitions.near(pose_of(scene->truss, end).translation(), 1.2, end.face))
    EXPECT_FALSE(strides.exact(end, scene->transitions.all()[static_cast<std::size_t>(near)].foothold));
}

TEST_P(HemmedIn, ARouteIsFoundAllTheSame) {
  const Hemmed& given = GetParam();
  const Found found = plan_optimal(robot(), *scene, given.start, given.goal, {}, {}, {});
  ASSERT_EQ(found.outcome, Found::Outcome::kReached) << found.failure.message;
  expect_climbable(*scene, found.route);
  EXPECT_TRUE(same(found.route.start, given.start));
  EXPECT_TRUE(same(found.route.strides.back().to, given.goal));
  EXPECT_EQ(found.cost, static_cast<double>(found.route.strides.size()));
  EXPECT_LE(found.lower_bound, found.cost);
  const Foothold& end = given.at_start ? given.start : given.goal;
  const Foothold& gate = given.at_start ? found.route.strides.front().to : found.route.strides[found.route.strides.size() - 2].to;
  EXPECT_EQ(gate.face == end.face, given.own_face);
}

TEST_P(HemmedIn, GatesHaveStridesOfTheirOwnAndKeepOffWhatIsBanned) {
  const Hemmed& given = GetParam();
  const Foothold& end = given.at_start ? given.start : given.goal;
  Strides strides(robot(), *scene);
  Legs legs(strides);
  const auto filter = shared_reach_filter(robot());
  const std::vector<Stride> found = gates(strides, legs, *filter, end, {}, {});
  ASSERT_FALSE(found.empty());
  for (const Stride& gate : found) {
    expect_climbable(*scene, {end, {gate}});
    EXPECT_TRUE(legs.has_footing(gate.to, false));
  }
  const Foothold first = found.front().to;
  const Banned banned = [&](const Foothold&, const Foothold& to) {
    return to.face == first.face && (to.at - first.at).norm() < 0.02;
  };
  for (const Stride& gate : gates(strides, legs, *filter, end, banned, {})) EXPECT_FALSE(banned(end, gate.to));
}

INSTANTIATE_TEST_SUITE_P(Generated, HemmedIn, testing::ValuesIn(kHemmed), [](const auto& of) { return std::string(of.param.why); });

TEST(LevelSpread, PosturesAreLevelWithinLimitsAndPutTheSoleWhereTheirShiftsSay) {
  const LevelPostures level(robot(), StrideBounds(robot()).shift());
  double lowest = 1e9;
  for (const LevelPostures::Level& at : level.spread()) {
    lowest = std::min(lowest, at.height);
    for (const double one : at.shifts)
      for (const double other : at.shifts) {
        constexpr double tau = 0.7, heading = -1.1;
        const auto posture = level.posture(one, other, at.height, tau, heading);
        ASSERT_TRUE(posture) << one << ' ' << other << " at " << at.height;
        EXPECT_TRUE(within_limits(robot(), *posture, 1e-9));
        const Isometry3d sole = forward(robot(), *posture);
        const Vector2d place = one * direction(0.0) + robot().hip_distance * direction(tau) - other * direction(heading);
        EXPECT_LT((sole.translation() - Vector3d(place.x(), place.y(), 0.0)).norm(), 1e-9);
        EXPECT_LT((sole.linear() - Eigen::AngleAxisd(heading, Vector3d::UnitZ()).toRotationMatrix()).norm(), 1e-9);
      }
  }
  // No angle of the mechanisms allows a hip that is lower by a tenth of a millimetre.
  const auto& mechanism = robot().mechanism;
  for (int i = 0; i <= 1000; ++i) {
    const double phi = mechanism.greatest_phi() * i / 1000.0;
    const kinematics::Interval y = mechanism.offsets(phi);
    if (y.empty()) continue;
    EXPECT_GT(std::cos(phi) * (2.0 * y.low - robot().core), lowest - 1e-4);
  }
}

}  // namespace
}  // namespace foothold::hyrecro
