// The numbers of the file, both modules joined, the centre of mass, postures of the interface, shapes.
#include <gtest/gtest.h>

#include "foothold/errors.hpp"
#include "robot.hpp"

namespace foothold::octopod {
namespace {

TEST(OctopodModel, TheFileGivesThePapersNumbers) {
  const Model& model = octopod();
  EXPECT_DOUBLE_EQ(model.reach(), 0.2);
  EXPECT_DOUBLE_EQ(model.arm(), 0.16);
  EXPECT_DOUBLE_EQ(model.mass(), 5.2);
}

TEST(OctopodModel, NumbersThatCannotBeAreRefusedByTheirPath) {
  const RobotModel file = load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/octopod.yaml");
  const auto field_refused = [&](const char* path, double value) {
    auto quantities = file.quantities();
    quantities.find(path)->second.values.front() = value;
    try {
      Model::from_model(RobotModel(quantities));
    } catch (const InvalidModel& refused) {
      return refused.field();
    }
    return std::string("taken");
  };
  for (const char* path :
       {"leg.femur", "leg.tibia", "leg.femur_mass", "body.edges", "body.shoulders", "joint.neck", "joint.height"})
    EXPECT_EQ(field_refused(path, 0.0), path);
  EXPECT_EQ(field_refused("leg.coxa", -0.01), "leg.coxa");
  EXPECT_EQ(field_refused("leg.coxa", 0.02), "taken");
  EXPECT_EQ(field_refused("leg.foot", 0.1), "leg.foot");
}

TEST(OctopodBody, BothModulesMeetInTheBallJoint) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 1000; ++i) {
    const Coordinates at = random_coordinates(random);
    const Vector3d from_rear = rear(octopod(), at) * Vector3d(octopod().arm(), 0, 0);
    EXPECT_LT((from_rear - centre(octopod(), at)).norm(), 1e-14);
    EXPECT_NEAR((centre(octopod(), at) - at.front.translation()).norm(), octopod().arm(), 1e-14);
  }
}

// Every body and link as a point mass in its middle.
TEST(OctopodBody, TheCentreOfMassIsThatOfAllBodies) {
  std::mt19937_64 random(6);
  const Model& model = octopod();
  for (int i = 0; i < 1000; ++i) {
    const Coordinates at = random_coordinates(random);
    Vector3d moment = 1.6 * at.front.translation() + 1.6 * rear(model, at).translation();
    for (int which = 0; which < kLegs; ++which) {
      const LegPoints points = leg(model, at, which);
      moment += 0.15 * (points.shoulder + points.knee) / 2 + 0.10 * (points.knee + points.foot) / 2;
    }
    EXPECT_LT((centre_of_mass(model, at) - moment / 5.2).norm(), 1e-14);
  }
}

TEST(OctopodBody, PosturesOfTheInterfaceGoBothWays) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 1000; ++i) {
    Coordinates at = random_coordinates(random);
    if (i % 10 == 0)
      at.ball = Eigen::AngleAxisd(uniform(random, -3, 3), Vector3d::UnitZ()) *
                Eigen::AngleAxisd((i % 20 == 0 ? 0.5 : -0.5) * std::numbers::pi, Vector3d::UnitY());
    const Posture posture = to_posture(at);
    ASSERT_EQ(posture.joints.size(), static_cast<std::size_t>(kJoints));
    const Coordinates back = from_posture(posture);
    EXPECT_LT(back.ball.angularDistance(at.ball), 1e-7);
    EXPECT_EQ(back.front.matrix(), at.front.matrix());
    EXPECT_EQ(back.legs, at.legs);
  }
}

TEST(OctopodBody, APostureWithAJointTooFewIsRefused) {
  Posture posture = to_posture(Coordinates{});
  posture.joints.pop_back();
  EXPECT_THROW(from_posture(posture), InvalidRequest);
}

TEST(OctopodBody, ShapesLieWhereTheLinksAre) {
  std::mt19937_64 random(8);
  const Coordinates at = random_coordinates(random);
  const std::vector<Shape> all = shapes(octopod(), at);
  ASSERT_EQ(all.size(), 20u);
  EXPECT_EQ(all[0].body, "A body");
  EXPECT_EQ(all[2].body, "B body");
  for (int which = 0; which < kLegs; ++which) {
    const LegPoints points = leg(octopod(), at, which);
    const Shape& femur = all[4 + 2 * static_cast<std::size_t>(which)];
    const Shape& tibia = all[5 + 2 * static_cast<std::size_t>(which)];
    EXPECT_EQ(femur.body, limb(which) + " femur");
    EXPECT_LT((femur.pose * Vector3d(0, 0, -0.05) - points.shoulder).norm(), 1e-14);
    EXPECT_LT((femur.pose * Vector3d(0, 0, 0.05) - points.knee).norm(), 1e-14);
    EXPECT_LT((tibia.pose * Vector3d(0, 0, -tibia.size.z() / 2) - points.knee).norm(), 1e-14);
    EXPECT_NEAR((tibia.pose * Vector3d(0, 0, tibia.size.z() / 2) - points.foot).norm(), 0.03, 1e-14);
  }
}

}  // namespace
}  // namespace foothold::octopod
