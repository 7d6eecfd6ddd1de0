// From posture to posture on gentle and rough ground, judged by an eye that looks many times and by the plugin's own judge.
#include <gtest/gtest.h>

#include "contact/equilibrium.hpp"
#include "dense.hpp"
#include "octopod/check/check.hpp"

namespace foothold::octopod {
namespace {

std::optional<Standing> stand_at(const TestGround& ground, double x, double y, int heading) {
  const auto under = ground.surface.beneath({x, y, 5});
  if (!under) return std::nullopt;
  const Built built = stand(octopod(), ground.surface, under->point,
                            ground.terrain.normals[static_cast<std::size_t>(under->triangle)], heading, 0.0);
  if (built.hindrance != Hindrance::kNone) return std::nullopt;
  contact::Equilibrium judge{contact::FrictionCone::pyramid(10)};
  std::vector<contact::Contact> feet;
  for (const Footing& foot : built.standing.feet) feet.push_back({foot.point, foot.normal});
  if (!judge.judge(feet, built.standing.centre_of_mass, 0.4).stable) return std::nullopt;
  return built.standing;
}

struct Case {
  Standing from, to;
};
// Random neighbours `far` apart at most.
std::vector<Case> neighbours(const TestGround& ground, int count, double far, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Case> out;
  while (static_cast<int>(out.size()) < count) {
    const double x = uniform(random, -0.7, 0.7), y = uniform(random, -0.7, 0.7), angle = uniform(random, -3.14, 3.14);
    const double step = uniform(random, 0.02, far);
    const int heading = static_cast<int>(random() % kOrientations);
    const auto from = stand_at(ground, x, y, heading);
    const auto to = stand_at(ground, x + step * std::cos(angle), y + step * std::sin(angle), heading);
    if (from && to) out.push_back({*from, *to});
  }
  return out;
}

Step step_to(const Standing& to, std::vector<MotionPoint> motion) {
  Step out;
  out.after = to_posture(to.at);
  for (int which = 0; which < kLegs; ++which) {
    const Footing& foot = to.feet[static_cast<std::size_t>(which)];
    Contact contact;
    contact.limb = limb(which);
    contact.frame.translation() = foot.point;
    contact.frame.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), foot.normal).toRotationMatrix();
    out.placed.push_back(contact);
  }
  out.after.stance = out.placed;
  out.motion = std::move(motion);
  return out;
}

void expect_good(const TestGround& ground, const Case& each, const Transition& found, bool look_at_bodies) {
  ASSERT_FALSE(found.phases.empty());
  for (std::size_t i = 0; i < found.phases.size(); ++i) {
    ASSERT_GE(found.phases[i].way.size(), 2u);
    if (i > 0) {
      EXPECT_EQ(found.phases[i].way.front().legs, found.phases[i - 1].way.back().legs);
    }
  }
  const auto motion = to_motion(octopod(), found);
  EXPECT_EQ(motion.front().joints, to_posture(each.from.at).joints);
  EXPECT_EQ(motion.back().joints, to_posture(each.to.at).joints);
  for (std::size_t i = 0; i + 1 < motion.size(); ++i) {
    const double time = motion[i + 1].time - motion[i].time;
    ASSERT_GT(time, 0.0);
    for (std::size_t k = 0; k < motion[i].joints.size(); ++k)
      EXPECT_LE(std::abs(motion[i + 1].joints[k] - motion[i].joints[k]), octopod().joint_speed * time * (1 + 1e-9));
  }
  const Seen seen = see(octopod(), ground.terrain, each.from, each.to, motion, 0.4, 3, look_at_bodies);
  EXPECT_EQ(seen.unstable, 0);
  EXPECT_LT(seen.slip, 2.1e-4);
  EXPECT_LT(seen.depth, 0.0);
  EXPECT_LT(seen.foot_depth, 0.0);
  EXPECT_GT(seen.apart, 0.0);
  EXPECT_GE(seen.fewest_feet, 7);
  for (int which = 0; which < kLegs; ++which) EXPECT_EQ(seen.swings[static_cast<std::size_t>(which)], 1) << limb(which);
  EXPECT_GE(found.least_margin, 0.0);
}

TEST(OctopodTransition, EveryInstantIsInEquilibriumInReachAndClear) {
  int found = 0, none = 0;
  const auto level = level_ground(), slope = slope_ground(0.33, 0.7), gentle = bumpy_ground(0.02, 4), rough = bumpy_ground(0.05, 4);
  for (const TestGround* ground : {level.get(), slope.get(), gentle.get(), rough.get()})
    for (const Case& each : neighbours(*ground, 6, 0.12, 17)) {
      const bool yes = has_transition(octopod(), ground->surface, {}, each.from, each.to);
      TransitionFailure failure;
      const auto way = transition(octopod(), ground->surface, {}, each.from, each.to, &failure);
      ASSERT_EQ(yes, way.has_value()) << failure.because;
      EXPECT_EQ(yes, failure.because.empty()) << failure.because;
      if (!yes) {
        ++none;
        continue;
      }
      ++found;
      expect_good(*ground, each, *way, ground == rough.get());
    }
  EXPECT_GE(found, 15);
}

TEST(OctopodTransition, ThePluginsJudgeTakesThemAll) {
  int judged = 0;
  const auto slope = slope_ground(0.3, 0.2), rough = bumpy_ground(0.03, 8);
  for (const TestGround* ground : {slope.get(), rough.get()})
    for (const Case& each : neighbours(*ground, 4, 0.1, 23)) {
      const auto way = transition(octopod(), ground->surface, {}, each.from, each.to);
      if (!way) continue;
      ++judged;
      Posture before = to_posture(each.from.at);
      before.stance = step_to(each.from, {}).placed;
      const StepVerdict verdict =
          check_step(octopod(), ground->surface, step_to(each.to, to_motion(octopod(), *way)), before, CheckOptions{});
      EXPECT_TRUE(verdict.accepted) << verdict.reason;
    }
  EXPECT_GE(judged, 5);
}

TEST(OctopodTransitions, ATurnTakesStopsEachOfWhichIsAStepThatTheJudgeTakes) {
  const auto slope = slope_ground(0.25, 1.0), rough = bumpy_ground(0.02, 12);
  for (const TestGround* ground : {slope.get(), rough.get()}) {
    const auto from = stand_at(*ground, 0.1, 0.0, 6), to = stand_at(*ground, 0.16, 0.03, 7);
    ASSERT_TRUE(from && to);
    EXPECT_FALSE(has_transition(octopod(), ground->surface, {}, *from, *to)) << "the outer feet move by 0.24 m";
    EXPECT_TRUE(has_transitions(octopod(), ground->surface, {}, *from, *to));
    const auto parts = transitions(octopod(), ground->surface, {}, *from, *to);
    ASSERT_GE(parts.size(), 2u);
    Standing before = *from;
    for (const Transition& part : parts) {
      expect_good(*ground, {before, part.to}, part, false);
      Posture stood = to_posture(before.at);
      stood.stance = step_to(before, {}).placed;
      const StepVerdict verdict =
          check_step(octopod(), ground->surface, step_to(part.to, to_motion(octopod(), part)), stood, CheckOptions{});
      EXPECT_TRUE(verdict.accepted) << verdict.reason;
      before = part.to;
    }
    EXPECT_EQ(before.at.legs, to->at.legs);
    EXPECT_EQ(before.at.front.matrix(), to->at.front.matrix());
  }
}

TEST(OctopodTransitions, OneGoWhereOneIsEnoughAndNoneWhereNoStopHelps) {
  const auto level = level_ground();
  const auto here = stand_at(*level, 0, 0, 0), near = stand_at(*level, 0.08, 0, 0), far = stand_at(*level, 0.4, 0, 0);
  EXPECT_EQ(transitions(octopod(), level->surface, {}, *here, *near).size(), 1u);
  EXPECT_GE(transitions(octopod(), level->surface, {}, *here, *far).size(), 2u);
  TransitionFailure failure;
  EXPECT_TRUE(transitions(octopod(), level->surface, {.swing_height = 0.2}, *here, *near, &failure).empty());
  EXPECT_FALSE(has_transitions(octopod(), level->surface, {.swing_height = 0.2}, *here, *near));
  EXPECT_FALSE(failure.because.empty());
}

TEST(OctopodTransition, FeetTooFarApartAreRefusedWithTheLeg) {
  const auto level = level_ground();
  const auto here = stand_at(*level, 0, 0, 0), there = stand_at(*level, 0.5, 0, 0);
  TransitionFailure failure;
  EXPECT_FALSE(transition(octopod(), level->surface, {}, *here, *there, &failure));
  EXPECT_GE(failure.leg, 0);
  EXPECT_NE(failure.because.find("nowhere reaches both its old and its new foothold"), std::string::npos) << failure.because;
  EXPECT_FALSE(has_transition(octopod(), level->surface, {}, *here, *there));
}

TEST(OctopodTransition, OnGroundTooSlipperyThereIsNone) {
  const auto slope = slope_ground(0.3);
  const auto here = stand_at(*slope, 0, 0, 0), there = stand_at(*slope, 0.05, 0, 0);
  TransitionFailure failure;
  EXPECT_TRUE(has_transition(octopod(), slope->surface, {.friction = 0.35}, *here, *there));
  EXPECT_FALSE(transition(octopod(), slope->surface, {.friction = 0.29}, *here, *there, &failure));
  EXPECT_NE(failure.because.find("no equilibrium"), std::string::npos) << failure.because;
}

TEST(OctopodTransition, ASwingingFootGoesOverWhatStandsInItsWay) {
  // A low wall across the way of the feet, 6 cm high, 1 cm thick; it ends before it comes under the bodies.
  const auto wall = [](double height) {
    const double a = 0.33, b = 0.34, in = 0.16;
    return std::make_unique<TestGround>(terrain::make_terrain(mesh::joined({{-2, -2, 0},
                                                                            {2, -2, 0},
                                                                            {2, 2, 0},
                                                                            {-2, 2, 0},
                                                                            {a, in, 0},
                                                                            {b, in, 0},
                                                                            {b, 1, 0},
                                                                            {a, 1, 0},
                                                                            {a, in, height},
                                                                            {b, in, height},
                                                                            {b, 1, height},
                                                                            {a, 1, height}},
                                                                           {{0, 1, 2},
                                                                            {0, 2, 3},
                                                                            {8, 9, 10},
                                                                            {8, 10, 11},
                                                                            {4, 5, 9},
                                                                            {4, 9, 8},
                                                                            {5, 6, 10},
                                                                            {5, 10, 9},
                                                                            {6, 7, 11},
                                                                            {6, 11, 10},
                                                                            {7, 4, 8},
                                                                            {7, 8, 11}})));
  };
  const auto level = level_ground();
  const auto here = stand_at(*level, 0, 0, 0), there = stand_at(*level, 0.12, 0, 0);
  const auto low = wall(0.06);
  const auto way = transition(octopod(), low->surface, {}, *here, *there);
  ASSERT_TRUE(way);
  for (const MotionPoint& point : to_motion(octopod(), *way)) {
    const Coordinates at = mixed(point, point, 0.0);
    for (int which = 0; which < kLegs; ++which) {
      const LegPoints points = leg(octopod(), at, which);
      for (int k = 0; k <= 20; ++k) {
        const Vector3d p = points.foot + k / 20.0 * (points.knee - points.foot);
        EXPECT_FALSE(p.x() > 0.33 && p.x() < 0.34 && p.y() > 0.16 && p.y() < 1.0 && p.z() < 0.06) << limb(which);
      }
    }
  }
  TransitionFailure failure;
  EXPECT_FALSE(transition(octopod(), wall(0.3)->surface, {}, *here, *there, &failure)) << "too high to step over";
}

}  // namespace
}  // namespace foothold::octopod
