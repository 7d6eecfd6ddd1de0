// Requests that make no sense, each refused with the field at fault.
#include <gtest/gtest.h>

#include <limits>

#include "fixtures.hpp"
#include "planner.hpp"

namespace foothold::xrobin {
namespace {

class Requests : public testing::Test {
 protected:
  std::string refused(const Request& request, const std::map<std::string, std::string>& set = {}) {
    const Parameters values = parameters(set);
    const auto scene = planner_.prepare({}, values);
    Collector out;
    try {
      planner_.start(request, values, *scene);
      planner_.plan(request, values, *scene, out);
    } catch (const InvalidRequest& fault) {
      EXPECT_TRUE(out.steps.empty());
      EXPECT_STRNE(fault.what(), "");
      return fault.field();
    }
    return "accepted";
  }

  static Contact contact(const char* limb, double x, double y, double heading) {
    return {limb, contact_frame({x, y, heading}), ""};
  }

  XrobinPlanner planner_{robot()};
  Request request_ = request_to(0.1, 0.1);
};

TEST_F(Requests, AcceptsWhatItsSchemaSays) { EXPECT_EQ(refused(request_, {{"cycles", "3"}}), "accepted"); }

TEST_F(Requests, RefusesAGoalWithoutABase) {
  request_.goal.base.reset();
  EXPECT_EQ(refused(request_, {{"cycles", "3"}}), "goal.base");
}

TEST_F(Requests, RefusesGoalsOfContactsOrJoints) {
  Request contacts = request_;
  contacts.goal.contacts = {contact("A", 0, 0, 0)};
  EXPECT_EQ(refused(contacts, {{"cycles", "3"}}), "goal.contacts");
  request_.goal.joints = {0.1, 0.1};
  EXPECT_EQ(refused(request_, {{"cycles", "3"}}), "goal.joints");
}

TEST_F(Requests, RefusesAGoalOffThePlane) {
  Request tilted = request_;
  tilted.goal.any_orientation = false;
  tilted.goal.base->rotate(Eigen::AngleAxisd(0.1, Vector3d::UnitX()));
  EXPECT_EQ(refused(tilted, {{"cycles", "3"}}), "goal.base.orientation");
  request_.goal.base->translation().z() = 0.01;
  EXPECT_EQ(refused(request_, {{"cycles", "3"}}), "goal.base.position");
}

TEST_F(Requests, RefusesNumbersThatAreNone) {
  request_.goal.base->translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused(request_, {{"cycles", "3"}}), "goal.base");
}

TEST_F(Requests, RefusesStartsThatContradictThemselves) {
  const Mechanism m = mechanism();
  Request one_foot = request_;
  one_foot.start.contacts = {contact("A", 0, 0, 0)};
  EXPECT_EQ(refused(one_foot, {{"cycles", "3"}}), "start.contacts");

  Request apart = request_;
  apart.start.contacts = {contact("A", 0, 0, 0), contact("B", 0.01, 0.02, 0)};
  EXPECT_EQ(refused(apart, {{"cycles", "3"}}), "start.contacts");

  Request unknown = request_;
  unknown.start.contacts = {contact("A", 0, 0, 0), contact("C", 0, 0.05, 0)};
  EXPECT_EQ(refused(unknown, {{"cycles", "3"}}), "start.contacts[1].limb");

  const PlanarPose a{0.2, 0.1, 0.4};
  const PlanarPose b = a * m.b_in_a(8);
  Request elsewhere = request_;
  elsewhere.start.contacts = {contact("B", b.x, b.y, b.heading), contact("A", a.x, a.y, a.heading)};
  EXPECT_EQ(refused(elsewhere, {{"cycles", "3"}}), "accepted");
  elsewhere.start.base = Isometry3d::Identity();
  EXPECT_EQ(refused(elsewhere, {{"cycles", "3"}}), "start.base");
  elsewhere.start.base.reset();
  elsewhere.start.joints = {m.lengths().retracted, m.lengths().retracted};
  EXPECT_EQ(refused(elsewhere, {{"cycles", "3"}}), "start.joints");
  elsewhere.start.joints = {m.lengths().extended, m.lengths().retracted};
  EXPECT_EQ(refused(elsewhere, {{"cycles", "3"}}), "accepted");
}

TEST_F(Requests, RefusesHeadingsForTheGreedyMethod) {
  request_.goal.any_orientation = false;
  EXPECT_EQ(refused(request_, {{"cycles", "3"}, {"method", "greedy"}}), "goal.any_orientation");
}

TEST_F(Requests, RefusesManyCyclesForBruteForce) {
  EXPECT_EQ(refused(request_, {{"cycles", "5"}, {"method", "brute_force"}}), "parameters.cycles");
  EXPECT_EQ(refused(request_, {{"cycles", "2"}, {"method", "brute_force"}}), "accepted");
}

}  // namespace
}  // namespace foothold::xrobin
