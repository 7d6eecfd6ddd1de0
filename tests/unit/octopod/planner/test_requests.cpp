// What cannot be planned for is refused with the field and the reason.
#include <filesystem>

#include "planning.hpp"

namespace foothold::octopod {
namespace {

std::string refused_field(const Request& request, const std::map<std::string, std::string>& set = {},
                          std::string* reason = nullptr) {
  try {
    const Parameters values = parameters(set);
    const auto scene = shared_planner().prepare(shipped("terrain-ramps"), values);
    Collector out;
    shared_planner().start(request, values, *scene);
    shared_planner().plan(request, values, *scene, out);
  } catch (const InvalidRequest& refused) {
    if (reason != nullptr) *reason = refused.what();
    return refused.field();
  }
  return "";
}

Request sound() { return request_between(kPaperStart, kPaperA); }

TEST(Requests, NameThePlacementAtFault) {
  std::string reason;
  Request request = sound();
  request.start.base.reset();
  EXPECT_EQ(refused_field(request), "start.base");

  request = sound();
  request.goal.base.reset();
  EXPECT_EQ(refused_field(request), "goal.base");

  request = sound();
  request.start.base->translation().z() += 0.4;
  EXPECT_EQ(refused_field(request, {}, &reason), "start.base.position");
  EXPECT_NE(reason.find("0.4 m from the terrain"), std::string::npos) << reason;

  request = sound();
  request.goal.base->translation().x() = 9.0;
  EXPECT_EQ(refused_field(request), "goal.base.position");

  request = sound();
  request.start.contacts = {Contact{}};
  EXPECT_EQ(refused_field(request), "start.contacts");

  request = sound();
  request.goal.joints.assign(kJoints, 0.0);
  EXPECT_EQ(refused_field(request), "goal.joints");

  request = sound();
  request.goal.any_orientation = false;
  EXPECT_EQ(refused_field(request), "goal.any_orientation");
}

TEST(Requests, SnapSaysHowFarFromTheTerrain) {
  Request request = sound();
  request.start.base->translation().z() += 0.15;
  EXPECT_EQ(refused_field(request), "start.base.position");
  EXPECT_EQ(refused_field(request, {{"snap", "0.2"}}), "");
}

TEST(Requests, NameTheParameterAtFault) {
  EXPECT_EQ(refused_field(sound(), {{"cone_edges", "2"}}), "parameters.cone_edges");
  EXPECT_EQ(refused_field(sound(), {{"cone_edges", "3"}}), "");
  EXPECT_EQ(refused_field(sound(), {{"transitions", "true"}, {"method", "paper"}}), "parameters.transitions");
  EXPECT_EQ(refused_field(sound(), {{"transitions", "true"}, {"stability", "false"}}), "parameters.transitions");
}

// On the second ramp's steep slope no friction of the terrain is enough.
TEST(Requests, AStartThatSlidesIsRefusedUnlessStabilityIsOff) {
  const std::map<std::string, std::string> slippery{{"friction", "0.01"}};
  const Request request = request_between(kPaperA, kPaperStart);
  std::string reason;
  EXPECT_EQ(refused_field(request, slippery, &reason), "start.base.position");
  EXPECT_NE(reason.find("unstable: needs a friction of"), std::string::npos) << reason;
}

TEST(Requests, TakeTheHeadingOfTheBase) {
  const Parameters values = parameters();
  const auto scene = shared_planner().prepare(shipped("terrain-ramps"), values);
  for (int eighth = 0; eighth < 8; ++eighth) {
    Request request = sound();
    request.start.any_orientation = false;
    const double heading = eighth * M_PI / 4 + 0.1;
    request.start.base->linear() = Eigen::AngleAxisd(heading, Vector3d::UnitZ()).toRotationMatrix();
    const Posture start = shared_planner().start(request, values, *scene);
    const Vector3d ahead = start.base.linear().col(0);
    EXPECT_NEAR(ahead.x(), std::cos(heading - 0.1), 0.05) << eighth;
    EXPECT_NEAR(ahead.y(), std::sin(heading - 0.1), 0.05) << eighth;
  }
}

TEST(Requests, LookTowardsTheGoalWhereAnyHeadingWillDo) {
  const Parameters values = parameters();
  const auto scene = shared_planner().prepare(shipped("terrain-ramps"), values);
  const Posture start = shared_planner().start(sound(), values, *scene);
  EXPECT_GT(start.base.linear().col(0).y(), 0.9);
  ASSERT_EQ(start.stance.size(), 8u);
  for (const Contact& contact : start.stance) EXPECT_NEAR(contact.frame.linear().determinant(), 1.0, 1e-12) << contact.limb;
}

TEST(Requests, ATerrainIsNeeded) {
  EXPECT_THROW(shared_planner().prepare({}, parameters()), InvalidScene);
  EXPECT_THROW(shared_planner().prepare(shipped("courtyard"), parameters()), InvalidScene);
}

}  // namespace
}  // namespace foothold::octopod
