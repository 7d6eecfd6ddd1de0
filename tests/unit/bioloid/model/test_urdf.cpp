// The model as URDF and back, another biped from a URDF by hand, and what is refused.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "another_biped.hpp"
#include "bioloid/model/urdf.hpp"
#include "foothold/errors.hpp"
#include "robot.hpp"
#include "temporary_folder.hpp"

namespace foothold::bioloid {
namespace {

using testing::biped_by_hand;
using testing::kDegree;
using testing::shipped_model;

RobotModel beside(const std::string& urdf) {
  std::map<std::string, Quantity, std::less<>> rest;
  const RobotModel shipped = load_robot_model(testing::kRobotFile);
  for (const auto& [path, quantity] : shipped.quantities())
    if (path == "sole.size" || path.starts_with("carrying.")) rest.emplace(path, quantity);
  return RobotModel(std::move(rest), {{"urdf", urdf}});
}

Model of_urdf(const std::string& urdf) { return Model::from_model(beside(urdf)); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

const std::string& shipped_urdf() {
  static const std::string text = write_urdf(shipped_model(), "bioloid");
  return text;
}

TEST(BioloidUrdf, ShippedFileIsTheModels) {
  std::ifstream in(FOOTHOLD_CONFIG_DIR "/robots/bioloid.urdf");
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_EQ(text.str(), shipped_urdf()) << "made anew by: foothold-bioloid-urdf bioloid.yaml";
}

TEST(BioloidUrdf, ReadBackItIsTheSameModel) {
  const Model &ours = shipped_model(), back = of_urdf(shipped_urdf());
  EXPECT_DOUBLE_EQ(back.mass(), ours.mass());
  EXPECT_EQ(back.sole(Side::kLeft), ours.sole(Side::kLeft));
  EXPECT_EQ(back.sole_length, ours.sole_length);
  EXPECT_EQ(back.carrying, ours.carrying);
  for (std::size_t j = 0; j < kJoints; ++j) {
    EXPECT_EQ(back.joints[j].parent, ours.joints[j].parent);
    EXPECT_EQ(back.joints[j].origin, ours.joints[j].origin);
    EXPECT_EQ(back.joints[j].axis, ours.joints[j].axis);
    EXPECT_EQ(back.joints[j].limits.low, ours.joints[j].limits.low);
    EXPECT_EQ(back.joints[j].limits.high, ours.joints[j].limits.high);
    EXPECT_EQ(back.joints[j].speed, ours.joints[j].speed);
  }
  for (std::size_t b = 0; b < kBodies; ++b) {
    EXPECT_EQ(back.bodies[b].name, ours.bodies[b].name);
    EXPECT_LT((back.bodies[b].centre_of_mass - ours.bodies[b].centre_of_mass).norm(), 1e-16);
    ASSERT_EQ(back.bodies[b].boxes.size(), ours.bodies[b].boxes.size());
    for (std::size_t i = 0; i < ours.bodies[b].boxes.size(); ++i) {
      EXPECT_EQ(back.bodies[b].boxes[i].centre, ours.bodies[b].boxes[i].centre);
      EXPECT_EQ(back.bodies[b].boxes[i].half, ours.bodies[b].boxes[i].half);
    }
    for (std::size_t other = 0; other < kBodies; ++other) EXPECT_EQ(back.neighbours(b, other), ours.neighbours(b, other));
  }
}

TEST(BioloidUrdf, AnotherBipedSolvesItsLegs) {
  const Model model = of_urdf(biped_by_hand());
  EXPECT_NEAR(model.mass(), 2.4 + 2 * (0.05 + 0.4 + 0.1 + 0.3 + 0.5 + 0.4 + 0.4), 1e-12);
  EXPECT_EQ(model.bodies[0].boxes.size(), 2u);
  EXPECT_LT((model.leg().thigh - Vector3d(0.01, 0, -0.2)).norm(), 1e-12);
  EXPECT_LT((model.leg().shin - Vector3d(-0.005, 0, -0.19)).norm(), 1e-12);
  EXPECT_LT((model.hip(Side::kRight) - Vector3d(0, -0.06, -0.05)).norm(), 1e-12);
  // The femur's frame is the torso's again behind two quarter turns: its centre of mass lies straight below, seen from the hip.
  EXPECT_LT((model.bodies[leg_joint(Side::kLeft, 2) + 1].centre_of_mass - Vector3d(0, 0, -0.1)).norm(), 1e-12);
  // Sole: hip (0, 0.06, -0.05), knee, ankle at (0.005, 0.06, -0.44), foot's frame 0.04 before, sole 0.02 behind and 0.01 outwards.
  const Vector3d sole = sole_in_torso(model, Side::kLeft, Joints::Zero()).translation();
  EXPECT_LT((sole - Vector3d(0.025, 0.07, -0.49)).norm(), 1e-12) << sole.transpose();

  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> angle(-1.2, 1.2);
  int reached = 0;
  for (int i = 0; i < 5000; ++i) {
    Joints joints;
    for (double& joint : joints) joint = angle(random);
    const auto frames = body_frames(model, joints);
    for (const Side side : {Side::kRight, Side::kLeft}) {
      const Isometry3d at = frames[leg_joint(side, 5) + 1] * Eigen::Translation3d(model.sole(side));
      EXPECT_LT((sole_in_torso(model, side, joints).matrix() - at.matrix()).cwiseAbs().maxCoeff(), 1e-12);
      double nearest = HUGE_VAL;
      for (const auto& angles : reach_all(model, side, at)) {
        double off = 0.0;
        for (std::size_t k = 0; k < kLegJoints; ++k)
          off = std::max(off, std::abs(angles[static_cast<int>(k)] - joints[static_cast<int>(leg_joint(side, k))]));
        nearest = std::min(nearest, off);
        ++reached;
      }
      EXPECT_LT(nearest, 1e-6);
    }
  }
  EXPECT_GT(reached, 40000);
}

TEST(BioloidUrdf, RobotsFileNamesIt) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "other.urdf") << biped_by_hand();
  std::ofstream(folder / "other.yaml") << "robot: other\nplugin: bioloid\nmodel:\n  urdf: other.urdf\n"
                                          "  sole: {size: {value: [180, 90], unit: mm, source: assumed}}\n  carrying:\n"
                                          "    shoulder_pitch: {value: 0, unit: deg, source: assumed}\n"
                                          "    shoulder_roll: {value: -10, unit: deg, source: assumed}\n"
                                          "    elbow: {value: -20, unit: deg, source: assumed}\n";
  const Model model = Model::from_model(load_robot_model(folder / "other.yaml"));
  EXPECT_EQ(model.sole_length, 0.18);
  EXPECT_DOUBLE_EQ(model.carrying[2], -10 * kDegree);
  EXPECT_DOUBLE_EQ(model.carrying[3], 10 * kDegree);
  EXPECT_DOUBLE_EQ(model.carrying[5], -20 * kDegree);
}

void expect_refused(const std::string& urdf, const std::string& field, const std::string& reason) {
  try {
    of_urdf(urdf);
    ADD_FAILURE() << "was taken, should not for " << reason;
  } catch (const InvalidModel& refused) {
    EXPECT_EQ(refused.field(), field) << refused.what();
    EXPECT_NE(std::string(refused.what()).find(reason), std::string::npos) << refused.what();
  }
}

TEST(BioloidUrdf, WrongStructuresAreRefusedWithTheElementsName) {
  const std::string& good = shipped_urdf();
  expect_refused("legs", "urdf", "cannot be read");
  expect_refused("<robot name='a'/>", "urdf", "cannot be read");
  expect_refused(replaced(good, "name=\"l_knee\"", "name=\"l_kneecap\""), "urdf.joint[l_kneecap]", "none of the robot's joints");
  expect_refused(replaced(good, "name=\"r_hip_yaw\" type=\"revolute\"", "name=\"r_hip_yaw\" type=\"fixed\""),
                 "urdf.joint[r_hip_yaw]", "is missing");
  expect_refused(replaced(good, "name=\"r_elbow\" type=\"revolute\"", "name=\"r_elbow\" type=\"prismatic\""), "urdf.joint[r_elbow]",
                 "must be revolute");
  expect_refused(replaced(good, "name=\"l_sole\" type", "name=\"l_heel\" type"), "urdf.joint[l_sole]", "is missing");

  const std::string biped = biped_by_hand();
  expect_refused(replaced(biped, "0 -0.06 0'", "0.001 -0.06 0'"), "urdf.joint[l_hip_yaw]", "is not the right side's mirrored");
  expect_refused(replaced(biped, "0 -0.03 0'", "0 -0.032 0'"), "urdf.joint[r_hip_pitch]", "passes the hip's yaw axis at 2.0");
  expect_refused(replaced(biped, "-0.03 0 -0.05", "-0.03 0.004 -0.05"), "urdf.joint[r_hip_roll]",
                 "passes the hip's yaw axis at 4.0");
  expect_refused(replaced(biped, "0.04 0 0'", "0.04 0 0.003'"), "urdf.joint[r_ankle_roll]", "passes the ankle's pitch axis at 3.0");
  expect_refused(replaced(biped, "0.04 0 0'", "0.04 0.002 0'"), "urdf.joint[r_ankle_roll]", "the plane of hip and knee at 2.0");
  expect_refused(replaced(biped, "-0.02 -0.01 -0.05", "-0.02 -0.012 -0.05"), "urdf.joint[l_sole]", "r_sole mirrored");
  expect_refused(replaced(biped, "<axis xyz='0 0 -1'/>", "<axis xyz='0 0.1 -1'/>"), "urdf.joint[r_hip_yaw]", "must turn about Z");
  expect_refused(replaced(biped, "lower='-2.4' upper='2.4'", "lower='2.4' upper='-2.4'"), "urdf.joint[r_shoulder_pitch]",
                 "lower limit");
  expect_refused(replaced(biped, "velocity='6'", "velocity='0'"), "urdf.joint[r_shoulder_pitch]", "speed above 0");
  expect_refused(replaced(biped, "<box size='0.1 0.16 0.2'/>", "<sphere radius='0.1'/>"), "urdf.link[trunk]", "collide as boxes");
  expect_refused(replaced(biped, "<collision><origin xyz='0 0 0.15'/>", "<collision><origin xyz='0 0 0.15' rpy='0 0 0.1'/>"),
                 "urdf.link[trunk]", "parallel to the torso");
  const std::string loop = "<joint name='again' type='fixed'><parent link='r_fore'/><child link='r_arm'/></joint>";
  expect_refused(replaced(biped, "</robot>", loop + "</robot>"), "urdf.link[r_arm]", "one joint that carries it");
}

TEST(BioloidUrdf, NumbersBesideItAreRefused) {
  auto quantities = beside("").quantities();
  quantities["torso.mass"] = {{1.0}, "kg", "assumed"};
  try {
    Model::from_model(RobotModel(quantities, {{"urdf", shipped_urdf()}}));
    ADD_FAILURE() << "was taken";
  } catch (const InvalidModel& refused) {
    EXPECT_EQ(refused.field(), "torso.mass");
  }
}

}  // namespace
}  // namespace foothold::bioloid
