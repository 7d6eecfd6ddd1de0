// Motions: the right ones, and each way to be wrong.
#include <gtest/gtest.h>

#include <functional>

#include "walk.hpp"

namespace foothold::hyrecro {
namespace {

using CheckOfMotions = CheckOfWalks;

TEST_F(CheckOfMotions, AcceptsRightOnesOfEitherFoot) {
  EXPECT_EQ(reason_after([](Walk&) {}), "accepted");
  Levels levels(model_, 1);
  int accepted = 0;
  for (int k = 0; k < 60; ++k) {
    const Walk w = walk(model_, k % 2 == 0 ? Foot::kA : Foot::kB, levels.foothold(), levels.level(), levels.level(), 10);
    const StepVerdict is = verdict(w);
    accepted += is.accepted;
    // Nothing is in their way but the robot itself.
    EXPECT_TRUE(is.accepted || is.reason.find("of each other") != std::string::npos) << is.reason;
  }
  EXPECT_GT(accepted, 20);
}

TEST_F(CheckOfMotions, RefusesEndsThatAreMissing) {
  expect_reason("the motion begins", [](Walk& w) { w.step.motion.erase(w.step.motion.begin()); });
  expect_reason("the motion ends", [](Walk& w) { w.step.motion.pop_back(); });
  expect_reason("the motion begins", [](Walk& w) { w.before.joints[2] += 1e-8; });
  expect_reason("the motion begins", [](Walk& w) { w.before.joints.pop_back(); });
  expect_reason("the motion's begin: the sole of foot B is sent",
                [](Walk& w) { w.before.stance[1].frame.translation().x() += 2e-6; });
}

// A hip has no stops: whole turns between the posture and the motion are the same.
TEST_F(CheckOfMotions, TakesWholeTurnsOfAHipForNothing) {
  EXPECT_EQ(reason_after([](Walk& w) { w.before.joints[8] += 6.283185307179586; }), "accepted");
  expect_reason("the motion begins", [](Walk& w) { w.before.joints[0] += 6.283185307179586; });
}

TEST_F(CheckOfMotions, RefusesTimesThatDoNotGrowAndJointsThatAreTooFast) {
  expect_reason("times must grow", [](Walk& w) { w.step.motion[5].time = w.step.motion[4].time; });
  expect_reason("motion point 0: its time is -1 s", [](Walk& w) { w.step.motion[0].time = -1.0; });
  expect_reason("m/s, 0.03 are allowed", [](Walk& w) {
    for (MotionPoint& point : w.step.motion) point.time *= 0.999;
  });
  EXPECT_EQ(reason_after([](Walk& w) {
              for (MotionPoint& point : w.step.motion) point.time *= 1.001;
            }),
            "accepted");
  expect_reason("rad from the point before", [](Walk& w) {
    for (std::size_t k = 30; k < w.step.motion.size(); ++k)
      w.step.motion[k].time += 1e3, w.step.motion[k].joints[8] += 12.566370614359172;
  });
}

TEST_F(CheckOfMotions, RefusesPointsThatAreWrongInThemselves) {
  expect_reason("motion point 7: the base is sent", [](Walk& w) { w.step.motion[7].base.translation().x() += 2e-6; });
  expect_reason("motion point 7: actuator A_l1 is 0.26 m long", [](Walk& w) { w.step.motion[7].joints[0] = 0.26; });
  expect_reason("motion point 7: 10 joints are needed, 0 are given", [](Walk& w) { w.step.motion[7].joints.clear(); });
}

TEST_F(CheckOfMotions, RefusesAFootThatDoesNotRiseOrSinkAlongTheNormal) {
  // Without the rungs the foot goes off its normal between the points.
  expect_reason("of the face that it leaves", [](Walk& w) {
    w.step.motion.erase(w.step.motion.begin() + 1, w.step.motion.begin() + 25);
    for (std::size_t k = 1; k < w.step.motion.size(); ++k) w.step.motion[k].time += 100.0;
  });
  expect_reason("of the face that it meets", [](Walk& w) {
    w.step.motion.erase(w.step.motion.end() - 25, w.step.motion.end() - 1);
    w.step.motion.back().time += 100.0;
  });
  // A foot that was in the air need not rise along anything.
  const auto in_the_air = [](Walk& w) {
    w.before.stance.pop_back();
    w.step.motion.erase(w.step.motion.begin() + 1, w.step.motion.begin() + 25);
    for (std::size_t k = 1; k < w.step.motion.size(); ++k) w.step.motion[k].time += 100.0;
  };
  EXPECT_EQ(reason_after(in_the_air).find("of the face that it leaves"), std::string::npos);
}

// A short piece, nearly straight, that is on the normal at its begin and high enough at its end, but goes aside on the way.
TEST_F(CheckOfMotions, RefusesAFootThatReachesItsHeightAside) {
  Walk w = walk(model_, Foot::kA, Isometry3d::Identity(), from_, to_, 100);
  EXPECT_TRUE(verdict(w).accepted) << verdict(w).reason;
  w.step.motion.erase(w.step.motion.begin() + 20, w.step.motion.begin() + 22);
  for (std::size_t k = 20; k < w.step.motion.size(); ++k) w.step.motion[k].time += 10.0;
  const StepVerdict is = verdict(w);
  EXPECT_FALSE(is.accepted);
  EXPECT_NE(is.reason.find("off the normal of the face that it leaves"), std::string::npos) << is.reason;
}

TEST_F(CheckOfMotions, RefusesWhatIsNoNumber) {
  const std::vector<std::function<void(Walk&)>> changes{
      [](Walk& w) { w.step.after.base.translation().x() = NAN; },
      [](Walk& w) { w.step.after.joints[4] = NAN; },
      [](Walk& w) { w.step.after.joints[8] = HUGE_VAL; },
      [](Walk& w) { w.step.placed[0].frame.linear()(0, 0) = NAN; },
      [](Walk& w) { w.step.placed[0].frame.translation().z() = w.step.after.stance[1].frame.translation().z() = NAN; },
      [](Walk& w) { w.before.stance[0].frame.translation().z() = w.step.after.stance[0].frame.translation().z() = NAN; },
      [](Walk& w) { w.before.stance[1].frame.translation().z() = NAN; },
      [](Walk& w) { w.before.joints[9] = NAN; },
      [](Walk& w) { w.step.motion[3].joints[1] = NAN; },
      [](Walk& w) { w.step.motion[3].joints[9] = -HUGE_VAL; },
      [](Walk& w) { w.step.motion[3].base.linear()(2, 1) = NAN; },
      [](Walk& w) { w.step.motion[3].time = NAN; },
      [](Walk& w) { w.step.motion[0].time = NAN; }};
  for (std::size_t k = 0; k < changes.size(); ++k) EXPECT_NE(reason_after(changes[k]), "accepted") << k;
}

// Thinner than what the foot goes between two points; both points are free of it.
TEST_F(CheckOfMotions, RefusesWhatPassesAThinObstacleBetweenItsPoints) {
  Level from = from_, to = from_;
  from.hip = {-0.6, 0.0}, to.hip = {0.6, 0.0};
  const Walk w = walk(model_, Foot::kB, Isometry3d::Identity(), from, to, 1);
  ASSERT_TRUE(verdict(w).accepted) << verdict(w).reason;
  const std::vector<double>& a = w.step.motion[21].joints;
  const std::vector<double>& b = w.step.motion[22].joints;
  std::vector<double> middle(kJoints);
  for (std::size_t k = 0; k < kJoints; ++k) middle[k] = 0.5 * (a[k] + b[k]);
  const Bodies at = bodies_at(model_, from_joints(model_, middle, Foot::kB), Isometry3d::Identity());
  for (const auto& [name, centre] : {std::pair{"leg A", Vector3d(0.5 * (at.leg[1].a + at.leg[1].b))},
                                     {"plate A", Vector3d(at.plate[1].pose * Vector3d(0.049, 0.0, 0.0))}}) {
    truss_ = floor_scene();
    add_box(truss_, "wire", centre, Vector3d(0.0005, 0.0005, 0.0005));
    const Obstacles obstacles(truss_);
    for (const MotionPoint& point : w.step.motion)
      ASSERT_TRUE(obstacles.free(bodies_at(model_, from_joints(model_, point.joints, Foot::kB), Isometry3d::Identity()), 0.005));
    const StepVerdict is = verdict(w);
    EXPECT_FALSE(is.accepted);
    EXPECT_NE(is.reason.find(name), std::string::npos) << is.reason;
    EXPECT_NE(is.reason.find("'wire'"), std::string::npos) << is.reason;
  }
}

TEST_F(CheckOfMotions, WithoutClearanceStillSeesCollisions) {
  options_.clearance = 0.0;
  EXPECT_EQ(reason_after([](Walk&) {}), "accepted");
  const Bodies at = bodies_at(model_, from_joints(model_, right_.step.motion[25].joints, Foot::kA), right_.before.stance[0].frame);
  add_box(truss_, "post", at.leg[1].b, {0.001, 0.001, 0.001});
  EXPECT_NE(reason_after([](Walk&) {}), "accepted");
}

}  // namespace
}  // namespace foothold::hyrecro
