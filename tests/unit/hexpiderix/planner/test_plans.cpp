// Requests to plans, each step judged as the host does.
#include <cmath>
#include <cstdlib>

#include "../planning.hpp"

namespace foothold::hexpiderix::testing {
namespace {

using Outcome = PlanReport::Outcome;

double figure(const PlanReport& report, const std::string& name) {
  for (const Margin& margin : report.figures)
    if (margin.name == name) return margin.value;
  ADD_FAILURE() << "no figure " << name;
  return 0.0;
}

struct Tally {
  int reached = 0, with_motion = 0, failed = 0;
};

// Every method on slopes in all directions: what is sent is accepted, what fails says why.
Tally over_slopes(const std::map<std::string, std::string>& set) {
  Tally out;
  const Parameters values = parameters(set);
  const double each = std::getenv("FOOTHOLD_LONG") != nullptr ? 5 : 20;
  for (double slope = 0; slope <= 60.0; slope += each)
    for (double direction = 5; direction < 360; direction += 50) {
      SCOPED_TRACE(std::to_string(slope) + " towards " + std::to_string(direction));
      const Ground ground(terrain::parse_terrain(bent_ground(slope * kDegree, slope * kDegree, direction * kDegree)));
      Collector collected;
      const PlanReport report = judged_plan(shared_planner(), request_at({0, 0, 0}), values, ground, collected);
      if (report.outcome == Outcome::kReached) {
        ++out.reached;
        EXPECT_FALSE(collected.steps.empty());
        if (collected.steps.empty()) continue;
        bool moves = true;
        for (const Step& step : collected.steps) moves = moves && !step.motion.empty();
        out.with_motion += moves;
        EXPECT_NEAR(report.cost, -figure(report, "NESM"), 1e-12);
        EXPECT_LE(report.lower_bound, report.cost);
        EXPECT_GE(figure(report, "friction needed"), std::tan(slope * kDegree) - 1e-6);
      } else {
        ++out.failed;
        EXPECT_TRUE(collected.steps.empty());
        EXPECT_FALSE(report.message.empty());
        EXPECT_FALSE(report.field.empty());
        EXPECT_NE(report.error, PlanError::kNone);
      }
    }
  return out;
}

TEST(Plans, MoreFreedomIsNeverLessStable) {
  const std::string text = bent_ground(50 * kDegree, 50 * kDegree, 30 * kDegree);
  const Ground ground(terrain::parse_terrain(text));
  double before = 0.0;
  const std::map<std::string, std::string> freedoms[] = {
      {}, {{"legs", "add"}}, {{"legs", "any"}}, {{"legs", "any"}, {"places", "any"}}};
  for (const auto& freedom : freedoms) {
    Collector collected;
    const PlanReport report = judged_plan(shared_planner(), request_at({0, 0, 0}), parameters(freedom), ground, collected);
    ASSERT_EQ(report.outcome, Outcome::kReached) << report.message;
    EXPECT_GE(figure(report, "NESM of the grid's best"), before);
    before = figure(report, "NESM of the grid's best");
  }
  EXPECT_GT(before, 0.03) << "feet farther out than in the standing robot";
}

struct Way {
  const char* name;
  std::map<std::string, std::string> set;
  double share;  // of the plans that reach, at least
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

class Ways : public ::testing::TestWithParam<Way> {};

TEST_P(Ways, SendWhatIsAcceptedOnEverySlopeOrSayWhyNot) {
  const Tally found = over_slopes(GetParam().set);
  std::printf("%s: %d reached, %d of them with motion, %d failed\n", GetParam().name, found.reached, found.with_motion,
              found.failed);
  EXPECT_GE(found.reached, GetParam().share * (found.reached + found.failed));
  EXPECT_EQ(found.with_motion, found.reached);
}

INSTANTIATE_TEST_SUITE_P(
    Each, Ways,
    ::testing::Values(Way{"Optimal", {}, 1.0}, Way{"OptimalTriad2", {{"supports", "triad2"}}, 1.0},
                      Way{"OptimalAllLegs", {{"supports", "all"}}, 1.0}, Way{"OptimalAddsLegs", {{"legs", "add"}}, 1.0},
                      Way{"OptimalPlacesLegs", {{"legs", "any"}, {"places", "any"}}, 1.0},
                      Way{"OptimalAnyLegs", {{"legs", "any"}}, 1.0},
                      Way{"OptimalWithFrictionForThirtyDegrees", {{"friction", "0.6"}}, 0.45},
                      Way{"OptimalWithClearance", {{"clearance", "0.005"}}, 1.0},
                      Way{"OptimalWithYaw", {{"yaw", "0.2"}, {"position_step", "0.03"}, {"tilt_step", "0.3"}}, 1.0},
                      Way{"Choice", {{"method", "choice"}}, 0.6}, Way{"Constant", {{"method", "constant"}}, 0.4},
                      Way{"Geometric", {{"method", "geometric"}}, 0.4}, Way{"Emergency", {{"method", "emergency"}}, 0.4},
                      Way{"EmergencyOnTriad2", {{"method", "emergency"}, {"supports", "triad2"}}, 0.4},
                      Way{"GeometricByAThird", {{"method", "geometric"}, {"share", "0.33"}}, 0.4}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(Plans, WalkUpTheShippedStairs) {
  const Parameters values = parameters();
  const auto scene = shared_planner().prepare(shipped("terrain-stairs"), values);
  Collector out;
  const PlanReport report = judged_plan(shared_planner(), walk_between({-0.6, 0, 0}, {0.6, 0, 0.37}), values, *scene, out);
  ASSERT_EQ(report.outcome, Outcome::kReached) << report.message;
  EXPECT_GE(figure(report, "least NESM"), 0.005);
  EXPECT_LT(figure(report, "distance to goal"), 0.1) << "the thorax leans uphill of the goal";
  EXPECT_NEAR(out.steps.back().cost, report.cost, 1e-9);
  EXPECT_LE(report.lower_bound, report.cost);
}

TEST(Plans, OfAWalkThatIsBlockedSayWhere) {
  const Ground level(terrain::parse_terrain(bent_ground(0, 0, 0)));
  Collector out;
  const PlanReport report = judged_plan(shared_planner(), walk_between({1, 0, 0}, {2.4, 0, 0}), parameters(), level, out);
  EXPECT_EQ(report.outcome, Outcome::kFailed);
  EXPECT_EQ(report.error, PlanError::kNoPath);
  EXPECT_EQ(report.field, "goal.base.position");
  EXPECT_NE(report.message.find("no ground under a foot"), std::string::npos) << report.message;
  EXPECT_TRUE(out.steps.empty());
}

TEST(Plans, ProveThatNoPostureIsStableWhereNoneIs) {
  const Ground wall(terrain::parse_terrain(bent_ground(84 * kDegree, 84 * kDegree, 0.0)));
  Collector out;
  const PlanReport report = judged_plan(shared_planner(), request_at({0, 0, 0}), parameters(), wall, out);
  EXPECT_EQ(report.outcome, Outcome::kFailed);
  EXPECT_EQ(report.error, PlanError::kUnstable);
  EXPECT_NE(report.message.find("proved"), std::string::npos) << report.message;
}

void expect_same(const std::vector<Step>& a, const std::vector<Step>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].label, b[k].label);
    EXPECT_EQ(a[k].cost, b[k].cost);
    EXPECT_EQ(a[k].after.joints, b[k].after.joints);
    EXPECT_TRUE(a[k].after.base.matrix() == b[k].after.base.matrix());
    ASSERT_EQ(a[k].placed.size(), b[k].placed.size());
    for (std::size_t i = 0; i < a[k].placed.size(); ++i)
      EXPECT_TRUE(a[k].placed[i].frame.matrix() == b[k].placed[i].frame.matrix());
    ASSERT_EQ(a[k].motion.size(), b[k].motion.size());
    for (std::size_t i = 0; i < a[k].motion.size(); ++i) {
      EXPECT_EQ(a[k].motion[i].time, b[k].motion[i].time);
      EXPECT_EQ(a[k].motion[i].joints, b[k].motion[i].joints);
    }
  }
}

TEST(Plans, AreTheSameBytesForTheSameRequestWhateverWasPlannedBefore) {
  const Ground slope(terrain::parse_terrain(bent_ground(0.3, 0.5, 1.0)));
  for (const char* method : {"optimal", "choice", "constant", "geometric", "emergency", "walk"}) {
    const bool walks = std::string(method) == "walk";
    const Parameters values = parameters({{"method", walks ? "optimal" : method}, {"least_nesm", "0.003"}});
    const Request request = walks ? walk_between({-0.5, 0, 0}, {0.1, 0.2, 0}) : request_at({0.1, 0, 0}, 0.4);
    Request on_ground = request;
    on_ground.start.base->translation() = on(slope, request.start.base->translation().x(), 0);
    if (walks) on_ground.goal.base->translation() = on(slope, 0.1, 0.2);
    HexpiderixPlanner fresh(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hexpiderix.yaml"));
    Collector first, second, warm_up;
    const PlanReport a = fresh.plan(on_ground, values, slope, first);
    shared_planner().plan(request_at({-1, 0, 0.3}), parameters(), slope, warm_up);
    const PlanReport b = shared_planner().plan(on_ground, values, slope, second);
    EXPECT_EQ(a.outcome, b.outcome);
    EXPECT_EQ(a.cost, b.cost) << method;
    EXPECT_EQ(a.lower_bound, b.lower_bound) << method;
    EXPECT_EQ(a.message, b.message) << method;
    EXPECT_TRUE(!first.steps.empty() || a.outcome == Outcome::kFailed) << method;
    expect_same(first.steps, second.steps);
  }
}

TEST(Plans, StopWhenTheyAreTold) {
  const Ground level(terrain::parse_terrain(bent_ground(0, 0, 0)));
  std::stop_source source;
  source.request_stop();
  for (const Request& request : {request_at({0, 0, 0}), walk_between({0, 0, 0}, {0.5, 0, 0})}) {
    Collector out;
    out.stop = source.get_token();
    EXPECT_EQ(shared_planner().plan(request, parameters(), level, out).outcome, Outcome::kStopped);
    EXPECT_TRUE(out.steps.empty());
  }
  Collector one;
  one.most = 1;
  EXPECT_EQ(shared_planner().plan(walk_between({0, 0, 0}, {0.5, 0, 0}), parameters(), level, one).outcome, Outcome::kStopped);
  EXPECT_EQ(one.steps.size(), 1U);
}

TEST(Plans, GiveUpAtTheLimitOfBoxes) {
  const Ground steep(terrain::parse_terrain(bent_ground(1.2, 1.2, 0)));
  Collector out;
  const PlanReport report = shared_planner().plan(request_at({0, 0, 0}), parameters({{"max_boxes", "3"}}), steep, out);
  EXPECT_EQ(report.outcome, Outcome::kFailed);
  EXPECT_EQ(report.error, PlanError::kSearchLimit);
  EXPECT_EQ(report.field, "parameters.max_boxes");
}

TEST(Plans, ShowTheRobot) {
  const Ground level(terrain::parse_terrain(bent_ground(0, 0, 0)));
  const Posture start = shared_planner().start(request_at({0, 0, 0}), parameters(), level);
  EXPECT_EQ(start.stance.size(), 3U);
  EXPECT_GE(shared_planner().shapes(start).size(), 13U) << "a thorax and two links of six legs at least";
}

}  // namespace
}  // namespace foothold::hexpiderix::testing
