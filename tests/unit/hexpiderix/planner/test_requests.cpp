// What cannot be planned for is refused with the field and the reason.
#include "../planning.hpp"
#include "hexpiderix/steps.hpp"

namespace foothold::hexpiderix::testing {
namespace {

using Set = std::map<std::string, std::string>;

std::string refused_field(const Request& request, const Set& set = {}, std::string* reason = nullptr) {
  static const Ground level(terrain::parse_terrain(bent_ground(0, 0, 0)));
  try {
    const Parameters values = parameters(set);
    Collector out;
    shared_planner().start(request, values, level);
    shared_planner().plan(request, values, level, out);
  } catch (const InvalidRequest& refused) {
    if (reason != nullptr) *reason = refused.what();
    return refused.field();
  }
  return "";
}

// The standing robot as a client gives it with joints: thorax 0.12 m above the level ground.
Request with_joints() {
  Request request;
  const Footholds feet = standing_footholds(shipped_model(), tilted_plane(0, 0), Vector3d::Zero(), 0.0, kTriad1);
  Coordinates at{standing_thorax(shipped_model(), tilted_plane(0, 0), Vector3d::Zero(), 0.0), {}};
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    at.legs[leg] = feet.supports[leg] ? standing_joints() : swinging_joints(shipped_model(), leg, shipped_model().lift);
  const Posture posture = standing_posture(at, feet);
  request.start.base = posture.base;
  request.start.joints = posture.joints;
  request.budget = 30.0;
  return request;
}

TEST(Requests, NameTheStartAtFault) {
  std::string reason;
  EXPECT_EQ(refused_field(request_at({0, 0, 0})), "");
  EXPECT_EQ(refused_field({}), "start.base");

  Request request = request_at({0, 0, 0});
  request.start.any_orientation = true;
  EXPECT_EQ(refused_field(request), "start.any_orientation");

  EXPECT_EQ(refused_field(request_at({0, 0, 0.4}), {}, &reason), "start.base.position");
  EXPECT_EQ(reason, "lies 0.4 m from the ground, at most 0.3 m are allowed (parameter snap)");
  EXPECT_EQ(refused_field(request_at({0, 0, 0.4}), {{"snap", "0.5"}}), "");

  EXPECT_EQ(refused_field(request_at({2.45, 0, 0}), {}, &reason), "start.base.position");
  EXPECT_NE(reason.find("no ground under foot L1"), std::string::npos) << reason;
}

TEST(Requests, NameTheContactAtFault) {
  std::string reason;
  Request request = request_at({0, 0, 0});
  for (const char* limb : {"L1", "L2"}) request.start.contacts.push_back({limb, Isometry3d::Identity(), ""});
  EXPECT_EQ(refused_field(request, {}, &reason), "start.contacts");
  EXPECT_NE(reason.find("three legs"), std::string::npos) << reason;
  request.start.contacts.push_back({"L2", Isometry3d::Identity(), ""});
  EXPECT_EQ(refused_field(request, {}, &reason), "start.contacts[2].limb");
  EXPECT_NE(reason.find("given twice"), std::string::npos) << reason;
  request.start.contacts[2].limb = "L7";
  EXPECT_EQ(refused_field(request), "start.contacts[2].limb");
  request.start.contacts[2].limb = "L4";
  EXPECT_EQ(refused_field(request), "");
}

TEST(Requests, NameTheJointAtFault) {
  std::string reason;
  EXPECT_EQ(refused_field(with_joints()), "");
  Request request = with_joints();
  request.start.joints.pop_back();
  EXPECT_EQ(refused_field(request, {}, &reason), "start.joints");
  EXPECT_NE(reason.find("must be 18 values, are 17"), std::string::npos) << reason;
  request = with_joints();
  request.start.joints[5] = 0.1;
  EXPECT_EQ(refused_field(request, {}, &reason), "start.joints[5]");
  request = with_joints();
  request.start.base->translation().z() += 0.01;
  EXPECT_EQ(refused_field(request, {}, &reason), "start.joints") << "no foot is on the ground";
  EXPECT_NE(reason.find("has 0"), std::string::npos) << reason;
  request = with_joints();
  for (const char* limb : {"L1", "L2", "L3"}) request.start.contacts.push_back({limb, Isometry3d::Identity(), ""});
  EXPECT_EQ(refused_field(request, {}, &reason), "start.joints");
  EXPECT_NE(reason.find("foot L2 is"), std::string::npos) << reason;
}

TEST(Requests, NameTheGoalAtFault) {
  const Request sound = walk_between({0, 0, 0}, {0.2, 0, 0});
  EXPECT_EQ(refused_field(sound), "");
  Request request = sound;
  request.goal.contacts = {Contact{}};
  EXPECT_EQ(refused_field(request), "goal.contacts");
  request = sound;
  request.goal.joints.assign(18, 0.0);
  EXPECT_EQ(refused_field(request), "goal.joints");
  request = sound;
  request.goal.base->translation().z() = 1.0;
  EXPECT_EQ(refused_field(request), "goal.base.position");
  request = sound;
  request.start.joints.assign(18, 0.0);
  EXPECT_EQ(refused_field(request), "start.joints");
  request = sound;
  request.start.contacts = {Contact{}};
  EXPECT_EQ(refused_field(request), "start.contacts");
  request = sound;
  request.start.any_orientation = true;
  EXPECT_EQ(refused_field(request), "start.any_orientation");
  request = sound;
  request.start.base.reset();
  EXPECT_EQ(refused_field(request), "start.base");
  request = sound;
  request.start.base->translation().x() = 2.4;
  EXPECT_EQ(refused_field(request), "start.base");
  for (const bool contacts : {true, false}) {
    request = request_at({0, 0, 0});
    if (contacts) request.goal.contacts = {Contact{}};
    if (!contacts) request.goal.joints.assign(18, 0.0);
    EXPECT_EQ(refused_field(request), contacts ? "goal.contacts" : "goal.joints") << "a goal without a base";
  }
}

TEST(Requests, NameTheParameterAtFault) {
  EXPECT_EQ(refused_field(request_at({0, 0, 0}), {{"method", "choice"}, {"legs", "add"}}), "parameters.legs");
  EXPECT_EQ(refused_field(request_at({0, 0, 0}), {{"places", "any"}}), "parameters.places");
  EXPECT_EQ(refused_field(request_at({0, 0, 0}), {{"method", "emergency"}, {"legs", "any"}}), "parameters.legs");
  EXPECT_EQ(refused_field(request_at({0, 0, 0}), {{"lowest", "0.18"}}), "parameters.lowest");
}

TEST(Requests, ATerrainIsNeeded) {
  EXPECT_THROW(shared_planner().prepare({}, parameters()), InvalidScene);
  EXPECT_THROW(shared_planner().prepare(shipped("courtyard"), parameters()), InvalidScene);
}

}  // namespace
}  // namespace foothold::hexpiderix::testing
