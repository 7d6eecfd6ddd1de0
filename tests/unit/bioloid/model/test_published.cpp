// The shipped numbers against the published ones: limits of all servos, boxes, lengths of the leg.
#include <gtest/gtest.h>

#include <string>

#include "robot.hpp"

namespace foothold::bioloid {
namespace {

using testing::kDegree;
using testing::shipped_model;

TEST(BioloidPublished, LimitsOfAllServos) {
  // By ID; even ones mirror: pitches, knees and ankle pitches alike, yaws and rolls the other way round.
  constexpr double kLimits[kJoints][2] = {{-150, 150}, {-150, 150}, {-100, 91}, {-91, 100}, {-100, 100}, {-100, 100},
                                          {-95, 10},   {-10, 95},   {-73, 50},  {-50, 73},  {-128, 23},  {-128, 23},
                                          {-152, 0},   {-152, 0},   {-23, 99},  {-23, 99},  {-54, 74},   {-74, 54}};
  for (std::size_t j = 0; j < kJoints; ++j) {
    EXPECT_NEAR(shipped_model().joints[j].limits.low, kLimits[j][0] * kDegree, 1e-12) << name_at(kJointNames, j);
    EXPECT_NEAR(shipped_model().joints[j].limits.high, kLimits[j][1] * kDegree, 1e-12) << name_at(kJointNames, j);
  }
}

TEST(BioloidPublished, BoxesAndNeighbours) {
  const Model& model = shipped_model();
  const auto body = [&](const std::string& name) {
    std::size_t b = 0;
    while (b < kBodies && model.bodies[b].name != name) ++b;
    EXPECT_LT(b, kBodies) << name;
    return b;
  };
  const auto expect_box = [&](const std::string& name, std::size_t i, const Vector3d& millimetres) {
    const Body& found = model.bodies.at(body(name));
    ASSERT_GT(found.boxes.size(), i);
    EXPECT_LT((2000.0 * found.boxes[i].half - millimetres).norm(), 1e-9) << name;
  };
  expect_box("torso", 0, {90.5, 103, 63.5});
  expect_box("torso", 1, {54, 33, 44});
  for (const std::string side : {"r_", "l_"}) {
    expect_box(side + "hip_block", 0, {72, 40, 51});
    expect_box(side + "ankle_block", 0, {72, 40, 51});
    expect_box(side + "thigh", 0, {30, 49, 65});
    expect_box(side + "shin", 0, {51, 44, 33});
    expect_box(side + "foot", 0, {101, 61, 9});
    const auto are_neighbours = [&](const std::string& a, const std::string& b) {
      return model.neighbours(body(a == "torso" ? a : side + a), body(side + b));
    };
    for (const auto& [a, b] : {std::pair{"torso", "hip_bracket"},
                               {"torso", "hip_block"},
                               {"hip_bracket", "hip_block"},
                               {"hip_bracket", "thigh"},
                               {"hip_block", "thigh"},
                               {"thigh", "shin"},
                               {"shin", "ankle_block"},
                               {"shin", "foot"},
                               {"ankle_block", "foot"},
                               {"torso", "upper_arm"},
                               {"upper_arm", "forearm"}})
      EXPECT_TRUE(are_neighbours(a, b)) << a << " " << b;
    for (const auto& [a, b] : {std::pair{"torso", "thigh"},
                               {"hip_block", "shin"},
                               {"thigh", "ankle_block"},
                               {"thigh", "foot"},
                               {"torso", "forearm"},
                               {"forearm", "thigh"}})
      EXPECT_FALSE(are_neighbours(a, b)) << a << " " << b;
  }
  EXPECT_FALSE(model.neighbours(body("r_foot"), body("l_foot")));
  EXPECT_FALSE(model.neighbours(body("r_hip_block"), body("l_hip_block")));
}

TEST(BioloidPublished, LegsLengthsAndReach) {
  const Model& model = shipped_model();
  EXPECT_LT((model.leg().thigh - Vector3d(-0.0145, 0, -0.075)).norm(), 1e-15);
  EXPECT_LT((model.leg().shin - Vector3d(0.0145, 0, -0.075)).norm(), 1e-15);
  // The knee lies behind the line from hip to ankle: the leg is longest with it bent.
  double longest = 0.0, at = 0.0;
  for (double knee = -60.0; knee <= 0.0; knee += 0.01) {
    kinematics::BipedLeg::Angles angles = kinematics::BipedLeg::Angles::Zero();
    angles[3] = -knee * kDegree;
    const double length = model.leg().forward(angles).translation().norm();
    if (length > longest) at = knee;
    longest = std::max(longest, length);
  }
  EXPECT_NEAR(longest, 0.1528, 5e-5);
  EXPECT_NEAR(at, -21.9, 0.05);
}

}  // namespace
}  // namespace foothold::bioloid
