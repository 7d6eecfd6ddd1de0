// Requests that make no sense, each refused with the field at fault and a reason with values.
#include "fixtures.hpp"

namespace foothold::hyrecro {
namespace {

// One plate of 2 m by 1 m, and one beside it that stands upright.
constexpr char kFloor[] = R"(kind: truss
faces:
  - {name: floor, polygon: [[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]], normal: [0, 0, 1]}
  - {name: wall, polygon: [[0, 1, 0.2], [2, 1, 0.2], [2, 1, 1], [0, 1, 1]], normal: [0, -1, 0]}
)";

class Requests : public testing::Test {
 protected:
  struct Refusal {
    std::string field, reason;
  };
  Refusal refusal(const std::map<std::string, std::string>& set = {}) {
    const Parameters values = parameters(set);
    Collector out;
    try {
      const auto scene = planner().prepare(file_.scene(), values);
      planner().start(request_, values, *scene);
      planner().plan(request_, values, *scene, out);
    } catch (const InvalidRequest& fault) {
      EXPECT_TRUE(out.steps.empty());
      return {fault.field(), fault.what()};
    }
    return {"accepted", ""};
  }
  void expect_refused(const std::string& field, const std::string& part, const std::map<std::string, std::string>& set = {}) {
    const Refusal is = refusal(set);
    EXPECT_EQ(is.field, field) << is.reason;
    EXPECT_NE(is.reason.find(part), std::string::npos) << is.reason;
  }

  static HyrecroPlanner& planner() {
    static HyrecroPlanner planner(robot());
    return planner;
  }
  static Isometry3d on_floor(double x, double y, double z = 0.0) {
    return sole_at({x, y, z}, Vector3d::UnitZ(), Vector3d::UnitX());
  }

  SceneFile file_{kFloor};
  Request request_ = request_between(on_floor(0.3, 0.5), on_floor(0.6, 0.5));
};

TEST_F(Requests, AcceptsOneContactAndAFootholdToGoTo) {
  EXPECT_EQ(refusal({{"motion", "false"}}).field, "accepted");
  request_.start.contacts[0].limb = "B";
  EXPECT_EQ(refusal({{"motion", "false"}}).field, "accepted");
  request_.start.contacts[0].limb = "";
  EXPECT_EQ(refusal({{"motion", "false"}}).field, "accepted");
}

TEST_F(Requests, RefusesAStartThatIsNone) {
  request_.start.contacts.clear();
  expect_refused("start.contacts", "is missing");
}

TEST_F(Requests, RefusesMoreFeetThanTheRobotHas) {
  request_.start.contacts.resize(3, contact("B", on_floor(0.5, 0.5)));
  expect_refused("start.contacts", "3 contacts");
}

TEST_F(Requests, RefusesTheSameFootTwiceAndFeetWithoutAName) {
  request_.start.contacts.push_back(contact("A", on_floor(0.5, 0.5)));
  expect_refused("start.contacts[1].limb", "contacts[0]");
  request_.start.contacts[1].limb = "";
  expect_refused("start.contacts[1].limb", "A or B");
  request_.start.contacts[1].limb = "left";
  expect_refused("start.contacts[1].limb", "'left'");
}

TEST_F(Requests, RefusesWhatItDoesNotRead) {
  const Request whole = request_;
  request_.start.base = Isometry3d::Identity();
  expect_refused("start.base", "contacts");
  request_ = whole;
  request_.goal.base = Isometry3d::Identity();
  expect_refused("goal.base", "contacts");
  request_ = whole;
  request_.goal.joints.assign(kJoints, 0.2);
  expect_refused("goal.joints", "contacts");
  request_ = whole;
  request_.goal.any_orientation = true;
  expect_refused("goal.any_orientation", "orientation");
}

TEST_F(Requests, RefusesGoalsThatAreNotOneFootholdForEitherFoot) {
  request_.goal.contacts.push_back(contact("", on_floor(0.9, 0.5)));
  expect_refused("goal.contacts", "2 are");
  request_.goal.contacts.clear();
  expect_refused("goal.contacts", "none is");
  request_.goal.contacts = {contact("B", on_floor(0.6, 0.5))};
  expect_refused("goal.contacts[0].limb", "leave");
}

TEST_F(Requests, SaysHowFarOffTheNearestFaceAContactIs) {
  request_.goal.contacts = {contact("", on_floor(0.6, 0.5, 0.05))};
  expect_refused("goal.contacts[0].position", "'floor', is 0.05 m");
  request_.goal.contacts = {contact("", on_floor(2.3, 1.4))};
  expect_refused("goal.contacts[0].position", "0.5 m");
  request_.start.contacts = {contact("A", on_floor(-0.1, 0.5))};
  expect_refused("start.contacts[0].position", "0.1 m");
}

TEST_F(Requests, SaysByHowMuchAFootIsTilted) {
  request_.goal.contacts[0].frame.rotate(Eigen::AngleAxisd(0.1, Vector3d::UnitX()));
  expect_refused("goal.contacts[0].orientation", "5.73 deg");
}

TEST_F(Requests, SaysByHowMuchAPlateReachesOverTheEdge) {
  request_.goal.contacts = {contact("", on_floor(0.6, 0.03))};
  expect_refused("goal.contacts[0].position", "0.02 m over the edge of the face 'floor'");
  // Turned by 45 deg its corner reaches 0.0707 m.
  request_.goal.contacts[0].frame = on_floor(0.6, 0.06) * Eigen::AngleAxisd(std::numbers::pi / 4.0, Vector3d::UnitZ());
  expect_refused("goal.contacts[0].position", "0.01071 m");
}

TEST_F(Requests, TakesTheFaceThatIsNamedAndSaysWhichThereAre) {
  request_.goal.contacts[0].face = "floor";
  EXPECT_EQ(refusal({{"motion", "false"}}).field, "accepted");
  request_.goal.contacts[0].face = "wall";
  expect_refused("goal.contacts[0].position", "'wall'");
  request_.goal.contacts[0].face = "wal";
  expect_refused("goal.contacts[0].face", "wall");
}

TEST_F(Requests, RefusesJointsThatAreNone) {
  request_.start.joints.assign(9, 0.22);
  expect_refused("start.joints", "9");
  request_.start.joints.assign(10, 0.22);
  request_.start.joints[3] = 0.26;
  expect_refused("start.joints[3]", "0.26");
}

TEST_F(Requests, RefusesJointsThatDoNotLeadFromFootToFoot) {
  request_.start.joints.assign(10, 0.22);
  request_.start.joints[8] = request_.start.joints[9] = 0.0;
  request_.start.contacts.push_back(contact("B", on_floor(0.6, 0.5)));
  // Both legs upright and parallel: B stands 0.156 m before A, not 0.3 m.
  expect_refused("start.joints", "0.144 m");
}

TEST_F(Requests, RefusesTwoContactsThatNoPostureStandsOn) {
  request_.start.contacts.push_back(contact("B", on_floor(1.5, 0.5)));
  expect_refused("start.contacts", "no posture");
}

TEST_F(Requests, RefusesParametersThatDoNotGoTogether) {
  expect_refused("parameters.heading_step", "divide", {{"heading_step", "0.09"}});
  expect_refused("parameters.reachability", "method paper", {{"reachability", "network"}});
  expect_refused("parameters.clearance", "the networks know 0.005 m alone",
                 {{"method", "paper"}, {"reachability", "network"}, {"clearance", "0.01"}});
  expect_refused("parameters.face_rule", "method paper", {{"face_rule", "zhu"}});
  expect_refused("parameters.face_way", "method paper", {{"face_way", "grid"}});
  expect_refused("parameters.objective", "method paper", {{"method", "paper"}, {"objective", "distance"}});
}

TEST_F(Requests, RefusesARequestWithoutAScene) { EXPECT_THROW(planner().prepare({}, parameters()), InvalidScene); }

}  // namespace
}  // namespace foothold::hyrecro
