// Steps without motion: the right ones, and each way to be wrong.
#include <gtest/gtest.h>

#include <functional>

#include "hyrecro/check/on_face.hpp"
#include "walk.hpp"

namespace foothold::hyrecro {
namespace {

// Without a motion.
class CheckOfSteps : public CheckOfWalks {
 protected:
  CheckOfSteps() { right_.step.motion.clear(); }
};

TEST_F(CheckOfSteps, AcceptsRightOnesOfEitherFoot) {
  Levels levels(model_, 1);
  int accepted = 0;
  for (int k = 0; k < 2000; ++k) {
    const Foot holds = k % 2 == 0 ? Foot::kA : Foot::kB;
    Walk w = walk(model_, holds, levels.foothold(), levels.level(), levels.level(), 1);
    w.step.motion.clear();
    const Bodies bodies = bodies_at(model_, from_joints(model_, w.step.after.joints, holds), w.before.stance[0].frame);
    const StepVerdict is = verdict(w);
    EXPECT_EQ(is.accepted, self_distance(bodies) >= 0.005) << is.reason;
    accepted += is.accepted;
    for (const Margin& margin : is.margins) EXPECT_GE(margin.value, margin.least) << margin.name;
    EXPECT_EQ(is.margins.size(), is.accepted ? 5u : 0u);
  }
  EXPECT_GT(accepted, 1000);
}

TEST_F(CheckOfSteps, SaysHowMuchRoomThereIs) {
  truss_.faces[0].outline = {{-1.5, -1.5}, {1.5, -1.5}, {1.5, 1.5}, {-1.5, 1.5}};
  const StepVerdict is = verdict(right_);
  ASSERT_TRUE(is.accepted) << is.reason;
  double reach = 1.0;
  for (std::size_t k = 0; k < 8; ++k)
    reach = std::min({reach, right_.step.after.joints[k] - 0.19, 0.25 - right_.step.after.joints[k]});
  EXPECT_EQ(is.margins[0].name, "reach");
  EXPECT_NEAR(is.margins[0].value, reach, 1e-12);
  EXPECT_EQ(is.margins[1].name, "clearance");
  const Bodies bodies = bodies_at(model_, from_joints(model_, right_.step.after.joints, Foot::kA), right_.before.stance[0].frame);
  const double low = std::min({bodies.leg[0].a.z(), bodies.leg[1].a.z()}) - model_.leg_radius;
  EXPECT_NEAR(is.margins[1].value, low, 2e-6);
  EXPECT_NEAR(is.margins[2].value, self_distance(bodies), 4e-6);
  double edge = 1.0;
  for (const double x : {-0.05, 0.05})
    for (const double y : {-0.05, 0.05}) {
      const Vector3d corner = right_.step.placed[0].frame * Vector3d(x, y, 0.0);
      edge = std::min({edge, 1.5 - std::fabs(corner.x()), 1.5 - std::fabs(corner.y())});
    }
  EXPECT_NEAR(is.margins[3].value, edge, 1e-9);
}

TEST_F(CheckOfSteps, RefusesWhatIsNotOneFootPlaced) {
  expect_reason("one foot is placed in a step, not 0", [](Walk& w) { w.step.placed.clear(); });
  expect_reason("one foot is placed in a step, not 2", [](Walk& w) { w.step.placed.push_back(w.step.placed[0]); });
  expect_reason("there is no foot 'C'", [](Walk& w) { w.step.placed[0].limb = "C"; });
  expect_reason("there is no foot 'C'", [](Walk& w) { w.step.after.stance[1].limb = "C"; });
  expect_reason("foot B holds, but moves by", [](Walk& w) { w.step.placed[0].limb = "A"; });
  expect_reason("foot A did not hold before", [](Walk& w) { w.before.stance.erase(w.before.stance.begin()); });
  expect_reason("foot A shall hold, but does not", [](Walk& w) { w.step.after.stance.erase(w.step.after.stance.begin()); });
  expect_reason("foot B is placed, but does not hold", [](Walk& w) { w.step.after.stance.pop_back(); });
  expect_reason("foot B holds twice", [](Walk& w) { w.step.after.stance.push_back(w.step.after.stance[1]); });
  expect_reason("foot B is placed", [](Walk& w) { w.step.after.stance[1].frame.translation().x() += 1e-8; });
  expect_reason("but holds on 'wall'", [](Walk& w) { w.step.after.stance[1].face = "wall"; });
}

TEST_F(CheckOfSteps, RefusesAFootThatHoldsAndMoves) {
  expect_reason("foot A holds, but moves by 2e-09 m", [](Walk& w) { w.step.after.stance[0].frame.translation().y() += 2e-9; });
  expect_reason("foot A holds, but moves by",
                [](Walk& w) { w.step.after.stance[0].frame.rotate(Eigen::AngleAxisd(1e-8, Vector3d::UnitZ())); });
  expect_reason("foot A holds on face 'floor/top', but on 'wall'", [](Walk& w) { w.step.after.stance[0].face = "wall"; });
}

TEST_F(CheckOfSteps, RefusesContactsAndBasesThatTheJointsDoNotMake) {
  const auto shift_contact = [](Walk& w, double by) {
    for (Contact* contact : {&w.step.placed[0], &w.step.after.stance[1]}) contact->frame.translation().x() += by;
  };
  EXPECT_EQ(reason_after([&](Walk& w) { shift_contact(w, 5e-7); }), "accepted");
  expect_reason("the sole of foot B is sent 2e-06 m", [&](Walk& w) { shift_contact(w, 2e-6); });
  expect_reason("the sole of foot B is sent", [](Walk& w) {
    for (Contact* contact : {&w.step.placed[0], &w.step.after.stance[1]})
      contact->frame.rotate(Eigen::AngleAxisd(2e-6, Vector3d::UnitZ()));
  });
  for (std::size_t k = 0; k < kJoints; ++k)
    expect_reason("away from where the joints put it", [&](Walk& w) { w.step.after.joints[k] += 1e-5; });
  expect_reason("the base is sent 2e-06 m", [](Walk& w) { w.step.after.base.translation().z() += 2e-6; });
  expect_reason("the base is sent", [](Walk& w) { w.step.after.base.rotate(Eigen::AngleAxisd(2e-6, Vector3d::UnitX())); });
}

TEST_F(CheckOfSteps, RefusesJointsBeyondTheirLimits) {
  expect_reason("actuator A_r2 is 0.2500001 m long", [](Walk& w) { w.step.after.joints[3] = 0.2500001; });
  expect_reason("actuator B_l1 is 0.18 m long", [](Walk& w) { w.step.after.joints[4] = 0.18; });
  expect_reason("10 joints are needed, 9 are given", [](Walk& w) { w.step.after.joints.pop_back(); });
  expect_reason("joint hip_B is not a finite number", [](Walk& w) { w.step.after.joints[9] = NAN; });
  expect_reason("joint A_l1 is not a finite number", [](Walk& w) { w.step.after.joints[0] = HUGE_VAL; });
}

TEST_F(CheckOfSteps, RefusesAPlateThatDoesNotLieOnItsFace) {
  const Vector3d at = right_.step.placed[0].frame.translation();
  expect_reason("which the scene does not have", [](Walk& w) { w.step.placed[0].face = w.step.after.stance[1].face = "wall"; });
  const truss::Truss floor = truss_;
  truss_.faces[0].outline = {{-1.5, -1.5}, {at.x() + 0.045, -1.5}, {at.x() + 0.045, 1.5}, {-1.5, 1.5}};
  expect_reason("overhangs the edge of face 'floor/top' by", [](Walk&) {});
  truss_ = floor;
  truss_.faces[0].outline = {{-1.5, -1.5}, {at.x() - 0.2, -1.5}, {at.x() - 0.2, 1.5}, {-1.5, 1.5}};
  expect_reason("foot B stands beside face", [](Walk&) {});
  truss_ = floor;
  truss_.faces[0].holes = {{{at.x(), at.y()}, {at.x(), at.y() + 0.01}, {at.x() + 0.01, at.y()}}};
  expect_reason("overhangs a hole of face 'floor/top' by", [](Walk&) {});
  truss_.faces[0].holes = {
      {{at.x() - 1, at.y() - 1}, {at.x() - 1, at.y() + 1}, {at.x() + 1, at.y() + 1}, {at.x() + 1, at.y() - 1}}};
  expect_reason("foot B stands in a hole of face", [](Walk&) {});
  truss_ = floor;
  truss_.faces[0].frame.translation().z() = -3e-6;
  expect_reason("the sole of foot B is 3e-06 m above", [](Walk&) {});
  truss_ = floor;
  truss_.faces[0].frame.rotate(Eigen::AngleAxisd(-5e-6, Vector3d::UnitX()));
  truss_.faces[0].frame.translation() = at;
  expect_reason("is tilted by 5e-06 rad", [](Walk&) {});
}

TEST_F(CheckOfSteps, RefusesCollisionsByName) {
  const Bodies bodies = bodies_at(model_, from_joints(model_, right_.step.after.joints, Foot::kA), right_.before.stance[0].frame);
  const truss::Truss floor = truss_;
  add_box(truss_, "beam", bodies.leg[1].b + Vector3d(0.0, 0.0, 0.3), {0.5, 0.5, 0.05});
  EXPECT_EQ(reason_after([](Walk&) {}), "accepted");
  truss_ = floor;
  add_box(truss_, "beam", bodies.hip.pose.translation() + Vector3d(0.0, 0.0, 0.058), {0.02, 0.02, 0.05});
  expect_reason("the posture after: hip comes within 0.00", [](Walk&) {});
  expect_reason("m of 'beam', 0.005 m must be kept", [](Walk&) {});
  truss_ = floor;
  add_box(truss_, "post", 0.5 * (bodies.leg[1].a + bodies.leg[1].b), {0.01, 0.01, 0.01});
  expect_reason("leg B comes within 0 m of 'post'", [](Walk&) {});
  truss_ = floor;
  add_box(truss_, "kerb", bodies.plate[1].pose * Vector3d(0.05, 0.05, 0.0), {0.005, 0.005, 0.004});
  expect_reason("plate B is in 'kerb'", [](Walk&) {});
}

// Legs crossed: the plates overlap before anything else.
TEST_F(CheckOfSteps, RefusesARobotInItself) {
  Level crossed = to_;
  crossed.shift = {-0.04, 0.06}, crossed.hip = {0.0, 0.0};
  Walk w = walk(model_, Foot::kB, Isometry3d::Identity(), from_, crossed, 1);
  w.step.motion.clear();
  const StepVerdict is = verdict(w);
  ASSERT_FALSE(is.accepted);
  EXPECT_NE(is.reason.find("m of each other, 0.005 m must be kept"), std::string::npos) << is.reason;
}

// Against points sampled along the segment.
TEST(SignedDistance, OfASegmentToARectangle) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const truss::Vector2d half(0.5, 0.3);
  for (int k = 0; k < 3000; ++k) {
    const truss::Vector2d p(uniform(random), uniform(random)), q(uniform(random), uniform(random));
    const double is = signed_distance(half, p, q);
    double sampled = 10.0;
    for (int s = 0; s <= 400; ++s) {
      const truss::Vector2d r = (p + s / 400.0 * (q - p)).cwiseAbs() - half;
      sampled = std::min(sampled, r.maxCoeff() < 0.0 ? r.maxCoeff() : r.cwiseMax(0.0).norm());
    }
    EXPECT_LE(is, sampled + 1e-12);
    EXPECT_GE(is, sampled - (q - p).norm() / 800.0 - 1e-12);
  }
}

}  // namespace
}  // namespace foothold::hyrecro
