// What cannot be planned for is refused with the field and the reason.
#include "../planning.hpp"
#include "bioloid/sending.hpp"

namespace foothold::bioloid::testing {
namespace {

struct Refusal {
  std::string field, reason;
};

Refusal refused(const Request& request, const Set& set = {}) {
  BioloidPlanner& planner = shared_planner();
  try {
    const Parameters values = parameters(set);
    const auto floor = planner.prepare({}, values);
    Collector out;
    planner.start(request, values, *floor);
    planner.plan(request, values, *floor, out);
  } catch (const InvalidRequest& refusal) {
    return {refusal.field(), refusal.what()};
  }
  return {};
}

const Request kGood = walk_request(on_floor(0, 0, 0), on_floor(0.1, 0, 0));

Contact foot(const char* limb, double y) { return {limb, on_floor(0, y, 0), ""}; }

TEST(Requests, NameTheStartAtFault) {
  EXPECT_EQ(refused(kGood).field, "");
  Request request = kGood;
  request.start = {};
  EXPECT_EQ(refused(request).field, "start.base");
  request = kGood;
  request.start.any_orientation = true;
  EXPECT_EQ(refused(request).field, "start.any_orientation");
  request = kGood;
  request.start.base->translation().z() = 0.1;
  EXPECT_EQ(refused(request).field, "start.base.position");
  EXPECT_EQ(refused(request).reason, "the point between the feet must lie on the ground, z = 0; z is 0.1 m");
  request = kGood;
  request.start.base->rotate(Eigen::AngleAxisd(0.1, Vector3d::UnitX()));
  EXPECT_EQ(refused(request).field, "start.base.orientation");
}

TEST(Requests, NameTheContactsAtFault) {
  Request request = kGood;
  request.start.base.reset();
  request.start.contacts = {foot("right_foot", -0.0385)};
  EXPECT_EQ(refused(request).field, "start.contacts");
  request.start.contacts = {foot("right_foot", -0.0385), foot("tail", 0.0385)};
  EXPECT_EQ(refused(request).field, "start.contacts[1].limb");
  request.start.contacts = {foot("right_foot", -0.0385), foot("right_foot", 0.0385)};
  EXPECT_EQ(refused(request).field, "start.contacts[1].limb");
  request.start.contacts = {foot("right_foot", -0.0385), foot("left_foot", 0.0385)};
  EXPECT_EQ(refused(request).field, "");
  request.start.contacts = {foot("right_foot", -0.2), foot("left_foot", 0.2)};
  EXPECT_EQ(refused(request).field, "start.contacts") << "out of reach";
  request.start.contacts = {foot("right_foot", 0.0), foot("left_foot", 0.03)};
  EXPECT_EQ(refused(request).field, "start.contacts") << "one foot in the other";
}

TEST(Requests, NameTheJointsAtFault) {
  Request request = kGood;
  request.start.joints = {0.0, 0.0};
  EXPECT_EQ(refused(request).field, "start.joints");
  request.start.joints.assign(kJoints, 0.0);
  request.start.joints[12] = 0.1;
  EXPECT_EQ(refused(request).field, "start.joints[12]");
  EXPECT_NE(refused(request).reason.find("r_knee"), std::string::npos);
  request.start.joints[12] = 0.0;
  EXPECT_EQ(refused(request).field, "start.base.position") << "the torso's origin is not on the ground";
  request.start.base->translation().z() = 0.2105;
  EXPECT_EQ(refused(request).field, "");
  request.start.joints[15] = 0.3;
  EXPECT_EQ(refused(request).field, "start.joints") << "a foot that leans";
}

TEST(Requests, RefuseAStartThatFalls) {
  Request request = kGood;
  request.start.joints.assign(kJoints, 0.0);
  // Bent forward at the hips with straight legs: the torso hangs in front of the toes.
  request.start.joints[10] = request.start.joints[11] = -1.5;
  request.start.base.reset();
  request.start.contacts = {foot("right_foot", -0.0385), foot("left_foot", 0.0385)};
  const Refusal refusal = refused(request);
  EXPECT_EQ(refusal.field, "start.joints") << refusal.reason;
  EXPECT_NE(refusal.reason.find("centre of mass"), std::string::npos) << refusal.reason;
}

TEST(Requests, NameTheGoalAtFault) {
  Request request = kGood;
  request.goal = {};
  EXPECT_EQ(refused(request).field, "goal.base");
  request = kGood;
  request.goal.joints = {0.0};
  EXPECT_EQ(refused(request).field, "goal.joints");
  request = kGood;
  request.goal.base->translation().z() = 0.01;
  EXPECT_EQ(refused(request).field, "goal.base.position");
  request = kGood;
  request.goal.base.reset();
  request.goal.contacts = {foot("right_foot", -0.0385), foot("left_foot", 0.05)};
  EXPECT_EQ(refused(request).field, "goal.contacts");
  request.goal.contacts = {foot("right_foot", -0.0385), foot("left_foot", 0.0385)};
  EXPECT_EQ(refused(request).field, "");
}

TEST(Requests, NameParametersThatDoNotGoTogether) {
  EXPECT_EQ(refused(kGood, {{"step_length", "0.01"}, {"cell", "0.02"}}).field, "parameters.step_length");
}

}  // namespace
}  // namespace foothold::bioloid::testing
