// A mast on a foot that leans over its edge, and servos under a known load: when they fall and how far they give way is known.
#include <gtest/gtest.h>

#include "physics/walking.hpp"

namespace foothold::physics {
namespace {

constexpr double kFootMass = 0.5, kMastMass = 0.4, kHeight = 0.2, kHalfLength = 0.05, kG = 9.80665;

// A foot of 100 x 60 x 20 mm with a hinge about Y on its top, and a mass on a mast over it.
Walker mast() {
  WalkerLink foot{.name = "foot", .mass = kFootMass, .boxes = {{Vector3d::Zero(), {kHalfLength, 0.03, 0.01}}}};
  WalkerLink top{.name = "mast",
                 .parent = 0,
                 .origin = {0.0, 0.0, 0.01},
                 .axis = Vector3d::UnitY(),
                 .mass = kMastMass,
                 .centre_of_mass = {0.0, 0.0, kHeight}};
  return {.links = {foot, top}, .excluded = {}};
}

const Isometry3d kOnTheFloor(Eigen::Translation3d(0.0, 0.0, 0.01));

Walked lean(double angle, const Servo& servo) {
  WalkOptions options;
  options.servo = servo;
  options.speed = 0.2;
  return walk(mast(), {0}, kOnTheFloor, {VectorXd::Zero(1), VectorXd::Constant(1, angle), VectorXd::Constant(1, angle)}, options);
}

// The angle at which both masses' centre lies over `x`.
double angle_over(double x) { return std::asin(x * (kFootMass + kMastMass) / (kMastMass * kHeight)); }

TEST(Walking, TipsOverWhereTheCentreOfMassLeavesTheFoot) {
  const Servo stiff{.stiffness = 300.0, .damping = 5.0, .torque = 5.0};
  for (const double side : {-1.0, 1.0}) {
    const Walked stays = lean(side * angle_over(0.95 * kHalfLength), stiff),
                 falls = lean(side * angle_over(1.05 * kHalfLength), stiff);
    EXPECT_FALSE(stays.fell());
    EXPECT_TRUE(stands_at(stays, kOnTheFloor, 0.001, 0.01));
    EXPECT_TRUE(falls.fell());
    EXPECT_FALSE(stands_at(falls, kOnTheFloor, 0.5, 3.2));
  }
}

TEST(Walking, AServoGivesWayByItsLoadOverItsStiffness) {
  const Servo servo{.stiffness = 20.0};
  const double target = 0.3;
  const Walked leaned = lean(target, servo);
  const double angle = Eigen::AngleAxisd(leaned.links[0].linear().transpose() * leaned.links[1].linear()).angle();
  EXPECT_NEAR(servo.stiffness * (angle - target), kMastMass * kG * kHeight * std::sin(angle), 0.01);
  EXPECT_GT(angle, target + 0.01);
}

TEST(Walking, AServoWithTooLittleTorqueLetsGo) {
  for (const double share : {0.5, 1.5}) {
    const Servo servo{.stiffness = 20.0, .damping = 0.1, .torque = share * kMastMass * kG * kHeight * std::sin(0.3)};
    const Walked leaned = lean(0.3, servo);
    EXPECT_EQ(leaned.fell(), share < 1.0);
    EXPECT_LE(leaned.torque, servo.torque);
  }
}

TEST(Walking, SaysWhichLinksTouchEachOther) {
  Walker walker = mast();
  walker.links[1].boxes = {{{0.0, 0.0, 0.1}, {0.01, 0.01, 0.08}}};
  walker.links[0].boxes.push_back({{0.06, 0.0, 0.1}, {0.01, 0.03, 0.01}});
  const Walked clear = walk(walker, {0}, kOnTheFloor, {VectorXd::Zero(1), VectorXd::Constant(1, 0.2)});
  EXPECT_EQ(clear.touching, "");
  const Walked touches = walk(walker, {0}, kOnTheFloor, {VectorXd::Zero(1), VectorXd::Constant(1, 0.6)});
  EXPECT_EQ(touches.touching, "foot and mast");
  walker.excluded = {{0, 1}};
  EXPECT_EQ(walk(walker, {0}, kOnTheFloor, {VectorXd::Zero(1), VectorXd::Constant(1, 0.6)}).touching, "");
}

TEST(Walking, AMotionTakesItsOwnTimesAndItsPosturesBetweenThem) {
  const std::vector<TimedPosture> motion{
      {2.0, VectorXd::Zero(1)}, {2.5, VectorXd::Constant(1, 0.2)}, {4.0, VectorXd::Constant(1, -0.1)}};
  const std::vector<TimedPosture> beginning(motion.begin(), motion.end() - 1);
  const Walked all = walk(mast(), {0}, kOnTheFloor, motion), half = walk(mast(), {0}, kOnTheFloor, beginning);
  const auto angle = [](const Walked& walked) {
    return std::asin((walked.links[0].linear().transpose() * walked.links[1].linear())(0, 2));
  };
  EXPECT_NEAR(all.time, 2.0, 1e-9);
  EXPECT_NEAR(half.time, 0.5, 1e-9);
  EXPECT_NEAR(angle(half), 0.2, 0.005);
  EXPECT_NEAR(angle(all), -0.1, 0.005);
}

TEST(Walking, RefusesPosturesOfAnotherRobot) {
  EXPECT_THROW(walk(mast(), {0}, kOnTheFloor, {VectorXd::Zero(2)}), std::runtime_error);
  EXPECT_THROW(walk(mast(), {0}, kOnTheFloor, JointPath{}), std::runtime_error);
}

}  // namespace
}  // namespace foothold::physics
