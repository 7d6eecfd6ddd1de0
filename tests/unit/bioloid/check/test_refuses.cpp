// Each kind of fault, produced in a step that is sound without it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "steps.hpp"

namespace foothold::bioloid {
namespace {

using testing::kDegree;
using testing::shipped_model;
using testing::standing;
using testing::standing_with;
using testing::step_after;
using testing::StepOrder;

struct Case {
  Posture before = standing(shipped_model());
  Step step = step_after(shipped_model(), before, {});
  std::vector<Prism> obstacles;
  CheckOptions options;
  StepVerdict judged() const { return check_step(shipped_model(), obstacles, step, before, options); }
};

// The step is refused, and for this reason.
void expect_refused(const Case& faulty, const std::string& reason) {
  const StepVerdict verdict = faulty.judged();
  EXPECT_FALSE(verdict.accepted);
  EXPECT_NE(verdict.reason.find(reason), std::string::npos) << "'" << verdict.reason << "' is not '" << reason << "'";
  EXPECT_TRUE(verdict.margins.empty());
}

// Joints of all points, and what follows from them.
void change_joints(Case& at, const std::function<void(std::size_t, std::vector<double>&)>& change) {
  for (std::size_t i = 0; i < at.step.motion.size(); ++i) change(i, at.step.motion[i].joints);
  at.before.joints = at.step.motion.front().joints;
  at.step.after.joints = at.step.motion.back().joints;
}

void remove_points(Case& at, std::size_t from, std::size_t count) {
  const auto begin = at.step.motion.begin() + static_cast<std::ptrdiff_t>(from);
  at.step.motion.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
}

constexpr std::size_t kLiftBegins = 30, kOverBegins = 36, kOverEnds = 56, kDown = 62;

TEST(BioloidCheckRefuses, ContactsThatAreNone) {
  Case sound;
  ASSERT_TRUE(sound.judged().accepted) << sound.judged().reason;

  Case at;
  at.step.placed[0].limb = "tail";
  expect_refused(at, "the limb 'tail'");
  at = Case{};
  at.before.stance.push_back(at.before.stance[0]);
  expect_refused(at, "right_foot twice");
  at = Case{};
  at.step.placed[0].frame.translation().z() = 1e-3;
  at.step.after.stance[1].frame = at.step.placed[0].frame;
  expect_refused(at, "is not on the ground");
  at = Case{};
  at.step.placed[0].frame.rotate(Eigen::AngleAxisd(1e-3, Vector3d::UnitX()));
  at.step.after.stance[1].frame = at.step.placed[0].frame;
  expect_refused(at, "is not on the ground");
}

TEST(BioloidCheckRefuses, StancesThatDoNotFollow) {
  Case at;
  at.step.placed.push_back(at.before.stance[0]);
  expect_refused(at, "places both");
  at = Case{};
  at.step.placed.clear();
  expect_refused(at, "left_foot is not placed, but stands");
  at = Case{};
  at.step.after.stance[0].frame.translation().x() += 1e-6;
  expect_refused(at, "right_foot is not placed, but stands");
  at = Case{};
  at.step.placed[0].frame.translation().x() += 1e-6;
  expect_refused(at, "is placed where the posture after does not have it");
  at = Case{};
  at.before.stance.pop_back();
  at.step.placed.clear();
  expect_refused(at, "neither stood before nor is placed");
  at = Case{};
  at.before.stance.erase(at.before.stance.begin());
  at.step.after.stance.erase(at.step.after.stance.begin());
  expect_refused(at, "no foot stands");
}

TEST(BioloidCheckRefuses, PosturesThatAreNotWhatTheySay) {
  Case at;
  at.step.after.joints.pop_back();
  expect_refused(at, "17 joints");
  at = Case{};
  at.step.motion[7].joints[3] = std::nan("");
  expect_refused(at, "not finite");
  at = Case{};
  at.step.placed[0].frame.translation().x() += 1e-5;
  at.step.after.stance[1].frame = at.step.placed[0].frame;
  expect_refused(at, "the posture after: the joints bring left_foot 1");
  at = Case{};
  at.step.after.base.translation().z() += 1e-5;
  expect_refused(at, "the posture after: the base is 1");
  at = Case{};
  at.step.motion[20].base.rotate(Eigen::AngleAxisd(1e-5, Vector3d::UnitX()));
  expect_refused(at, "the base is");
  at = Case{};
  change_joints(at, [](std::size_t, std::vector<double>& joints) { joints[4] = 101 * kDegree; });
  expect_refused(at, "r_elbow is at 1.76");
  at = Case{};
  at.step.motion[50].joints[5] = -101 * kDegree;
  expect_refused(at, "l_elbow is at -1.76");
}

TEST(BioloidCheckRefuses, MotionsThatDoNotFitTheirTimes) {
  Case at;
  at.step.motion.clear();
  expect_refused(at, "no motion");
  at = Case{};
  at.step.motion.front().joints[0] += 1e-8;
  expect_refused(at, "begin");
  at = Case{};
  at.step.motion.back().joints[0] += 1e-8;
  expect_refused(at, "end");
  at = Case{};
  at.step.motion.front().time = 1e-3;
  expect_refused(at, "not at 0");
  at = Case{};
  at.step.motion[9].time = at.step.motion[8].time;
  expect_refused(at, "times do not grow");
  at = Case{};
  for (MotionPoint& point : at.step.motion) point.time *= 0.05;
  expect_refused(at, "of its servo's speed");
}

TEST(BioloidCheckRefuses, BodiesThatMeet) {
  // Arms that hang straight meet the hip blocks.
  Case at;
  change_joints(at, [](std::size_t, std::vector<double>& joints) {
    joints[2] = 91 * kDegree;
    joints[3] = -91 * kDegree;
  });
  expect_refused(at, "_upper_arm and ");
  // A forearm that is bent inwards, in front of the body at one point and behind it at the next, goes through it between them.
  at = Case{};
  const Step still = at.step;
  at.step.motion.clear();
  for (int i = 0; i < 2; ++i) {
    MotionPoint point = still.motion.front();
    point.time = 2.0 * i;
    point.joints[4] = 95 * kDegree;
    point.joints[0] = (i == 0 ? -80 : 80) * kDegree;
    at.step.motion.push_back(point);
  }
  at.before.joints = at.step.motion.front().joints;
  at.step.after = at.before;
  at.step.after.joints = at.step.motion.back().joints;
  at.step.placed.clear();
  Case stays = at;
  stays.step.motion.back().joints = stays.before.joints;
  stays.step.after.joints = stays.before.joints;
  EXPECT_TRUE(stays.judged().accepted) << stays.judged().reason;
  stays.before.joints = at.step.after.joints;
  stays.step.motion.front().joints = stays.step.motion.back().joints = stays.step.after.joints = stays.before.joints;
  EXPECT_TRUE(stays.judged().accepted) << stays.judged().reason;
  expect_refused(at, "r_forearm");
}

TEST(BioloidCheckRefuses, WhatMeetsAnObstacle) {
  const Case sound;
  const auto box = [](double x, double y, double half, double height) {
    return Prism{"brick", {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}}, height};
  };
  // Where the foot comes to stand; beside it; high and in its way, then low enough to step over.
  Case at;
  at.obstacles = {box(0.09, 0.06, 0.01, 0.005)};
  expect_refused(at, "l_foot and the obstacle 'brick'");
  at.obstacles = {box(0.12, 0.06, 0.01, 0.005)};
  EXPECT_TRUE(at.judged().accepted) << at.judged().reason;
  at.obstacles = {box(0.105, 0.0, 0.05, 0.3)};
  expect_refused(at, "and the obstacle 'brick'");
  // Round the whole robot: none of its sides is near.
  at.obstacles = {box(0, 0, 2.0, 1.0)};
  expect_refused(at, "the obstacle 'brick' are 0 m apart");
  at.obstacles = {Prism{"dented", {{1, 0}, {2, 0}, {1.2, 0.2}, {1, 1}}, 0.1}};
  expect_refused(at, "the obstacle 'dented' is no prism");

  // A low bar across a long step's way: over it goes the lifted foot, and refused it is where the lift is too low.
  Case low;
  low.before.stance[1].frame.translation().x() = -0.05;
  low.before = standing(shipped_model());
  low.step = step_after(shipped_model(), low.before, {.forward = 0.05, .lift = 0.010});
  low.obstacles = {Prism{"bar", {{0.052, 0.02}, {0.054, 0.02}, {0.054, 0.06}, {0.052, 0.06}}, 0.009}};
  expect_refused(low, "l_foot and the obstacle 'bar'");
}

TEST(BioloidCheckRefuses, RobotsThatFall) {
  Case at;
  at.step = step_after(shipped_model(), at.before, {.beside = -0.021});
  expect_refused(at, "inside the soles' hull, less than 0.01 m");
  at.step = step_after(shipped_model(), at.before, {.beside = -0.019});
  EXPECT_TRUE(at.judged().accepted) << at.judged().reason;
  // The same with a wider demand.
  at.options.balance = 0.0115;
  expect_refused(at, "inside the soles' hull, less than 0.0115 m");
  // The foot is lifted before the centre of mass is over the other.
  at = Case{};
  at.step.motion.erase(at.step.motion.begin() + 1, at.step.motion.begin() + kLiftBegins + 1);
  expect_refused(at, "inside the soles' hull");
}

TEST(BioloidCheckRefuses, SolesThatSlip) {
  // Coarse points: linear in the joints between them the soles do not stay in place though they are in place at the points. (From
  // beside each other they do: the legs are a parallelogram.)
  Case at;
  remove_points(at, kDown + 1, 28);
  expect_refused(at, "the standing left_foot slips by");
  at = Case{};
  remove_points(at, kDown + 1, 2);
  EXPECT_TRUE(at.judged().accepted) << at.judged().reason;
  at.options.slip = 4e-5;
  expect_refused(at, "the standing left_foot slips by");
  // Nothing is placed, and one point is off.
  at = Case{};
  at.step.motion.resize(kLiftBegins + 3);
  at.step.after = Posture{at.step.motion[kLiftBegins].base, at.step.motion[kLiftBegins].joints, at.before.stance};
  MotionPoint back = at.step.motion[kLiftBegins];
  back.time = at.step.motion.back().time + 0.1;
  at.step.motion.push_back(back);
  at.step.placed.clear();
  expect_refused(at, "the standing left_foot slips by");
}

TEST(BioloidCheckRefuses, FeetThatAreNotLifted) {
  Case at;
  at.step = step_after(shipped_model(), at.before, {.lift = 0.0});
  expect_refused(at, "nor is above the ground");
  at = Case{};
  at.step = step_after(shipped_model(), at.before, {.lift = -0.002});
  expect_refused(at, "nor is above the ground");
  at = Case{};
  remove_points(at, kLiftBegins + 1, kOverEnds - kLiftBegins + 5);
  expect_refused(at, "without a point in the air");
  // Lifted at all points, but between two of them it swings through the ground like a pendulum.
  at = Case{};
  at.before = step_after(shipped_model(), standing(shipped_model(), 0.185), {.forward = 0.03, .pelvis = 0.185}).after;
  at.step = step_after(shipped_model(), at.before, {.moving = Side::kRight, .forward = 0.06, .lift = 0.002, .pelvis = 0.185});
  ASSERT_TRUE(at.judged().accepted) << at.judged().reason;
  remove_points(at, kOverBegins + 1, kOverEnds - kOverBegins - 1);
  for (std::size_t i = kOverBegins + 1; i < at.step.motion.size(); ++i) at.step.motion[i].time += 1.0;
  expect_refused(at, "below the ground");
}

}  // namespace
}  // namespace foothold::bioloid
