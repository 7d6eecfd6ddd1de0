// Plans among obstacles: exact against brute force, and every step judged.
#include <gtest/gtest.h>

#include <fstream>

#include "fixtures.hpp"
#include "obstacle_solver.hpp"
#include "planner.hpp"
#include "scenery.hpp"

namespace foothold::xrobin {
namespace {

Target random_goal(std::mt19937_64& random, double radius) {
  std::uniform_real_distribution<double> unit(-radius, radius);
  return {unit(random), unit(random), std::nullopt, 0.0};
}

class AmongObstacles : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(PrintedAndExactTurns, AmongObstacles, testing::Bool());

TEST_P(AmongObstacles, OptimalAgreesWithBruteForceOverWordsThatCanBeWalked) {
  const Ring ring{GetParam() ? Mechanism(with_exact_turns(0.103, 0.130)) : mechanism()};
  const Mechanism& m = ring.mechanism();
  const Bodies bodies = Bodies::from_model(robot(), mechanism());
  Solver solver(m);
  solver.prepare(Method::kOptimal, 3, 0, true, {});
  std::mt19937_64 random(31);
  int hindered = 0;
  for (int round = 0; round < 16; ++round) {
    const Surroundings surroundings(ring, bodies, random_obstacles(random, 6, 0.125, 0.4, 0.05), 0.001);
    const Stance start{{0.0, 0.0, 0.3}, 1 + round % 8};
    if (surroundings.nearest({start.a, start.a * m.b_in_a(start.configuration)}).distance <= 0.001) continue;
    const int cycles = 2 + round % 2;
    Target goal = random_goal(random, 0.2);
    if (round % 3 == 0) goal.heading = start.a.heading + 0.5 * std::numbers::pi, goal.heading_tolerance = 0.01;
    const Limits limits{.cycles = cycles, .max_cycles = cycles, .tolerance = 1e-6};
    Passage passage(surroundings, {});
    const Solution brute = ObstacleSolver(solver, passage, start, goal, limits, {}, {}).solve(Method::kBruteForce);
    const Solution found = ObstacleSolver(solver, passage, start, goal, limits, {}, {}).solve(Method::kOptimal);
    ASSERT_EQ(found.possible, brute.possible) << round;
    if (!brute.possible) continue;
    EXPECT_NEAR(found.distance, brute.distance, 1e-11) << round;
    EXPECT_NEAR(found.least_distance, brute.distance, 1e-9) << round;
    EXPECT_TRUE(clear_ways(m, passage, start, found.word).has_value()) << round;
    const std::optional<BestWord> open = best_of_all_words(m, cycles, seen_from(start.a, goal), {});
    if (open && open->distance < found.distance - 1e-9) ++hindered;
  }
  EXPECT_GT(hindered, 3);  // else the obstacles were not in the way
}

TEST_P(AmongObstacles, FewestAgreesWithBruteForce) {
  const Ring ring{GetParam() ? Mechanism(with_exact_turns(0.103, 0.130)) : mechanism()};
  const Mechanism& m = ring.mechanism();
  const Bodies bodies = Bodies::from_model(robot(), mechanism());
  Solver solver(m);
  solver.prepare(Method::kFewest, 3, 0, true, {});
  std::mt19937_64 random(32);
  for (int round = 0; round < 16; ++round) {
    const Surroundings surroundings(ring, bodies, random_obstacles(random, 5, 0.125, 0.4, 0.05), 0.001);
    const Stance start{{}, 1 + round % 8};
    if (surroundings.nearest({start.a, m.b_in_a(start.configuration)}).distance <= 0.001) continue;
    const Target goal = random_goal(random, 0.15);
    const Limits limits{.cycles = 3, .max_cycles = 3, .tolerance = 0.006};
    Passage passage(surroundings, {});
    int least = 4;
    for (int cycles = 1; cycles <= 3 && least == 4; ++cycles) {
      const auto best = best_of_all_walkable_words(m, passage, start, cycles, goal, {});
      if (best && best->distance <= limits.tolerance) least = cycles;
    }
    if (std::hypot(goal.x, goal.y) <= limits.tolerance) least = 0;
    const Solution found = ObstacleSolver(solver, passage, start, goal, limits, {}, {}).solve(Method::kFewest);
    EXPECT_EQ(found.least_cycles, least) << round;
    if (least <= 3) {
      EXPECT_EQ(static_cast<int>(found.word.size() / 2), least) << round;
      EXPECT_LE(found.distance, limits.tolerance) << round;
    } else {
      EXPECT_GT(found.distance, limits.tolerance) << round;
    }
  }
}

class Scenes : public testing::Test {
 protected:
  static XrobinPlanner& planner() {
    static XrobinPlanner planner(robot());
    return planner;
  }
  static Scene scene(const std::string& name) { return {name, "", "yaml", FOOTHOLD_CONFIG_DIR "/scenes/" + name + ".yaml"}; }

  PlanReport plan(const Scene& in, const Request& request, const Parameters& values) {
    const auto prepared = planner().prepare(in, values);
    const PlanReport report = planner().plan(request, values, *prepared, out_);
    Posture before = planner().start(request, values, *prepared);
    for (const Step& step : out_.steps) {
      const StepVerdict verdict = planner().check(step, before, values, *prepared);
      EXPECT_TRUE(verdict.accepted) << step.label << ": " << verdict.reason;
      before = step.after;
    }
    return report;
  }

  Collector out_;
};

TEST_F(Scenes, GoalsBehindObstaclesAreReached) {
  const std::tuple<const char*, double, double> cases[] = {
      {"pillars", 0.4, 0.4}, {"doorway", 0.05, 0.55}, {"courtyard", 0.0, 0.55}};
  for (const auto& [name, x, y] : cases)
    for (const char* method : {"optimal", "fewest"}) {
      out_.steps.clear();
      const PlanReport report = plan(scene(name), request_to(x, y), parameters({{"method", method}}));
      EXPECT_EQ(report.outcome, PlanReport::Outcome::kReached) << name << " " << method << ": " << report.message;
      const Vector3d end = out_.steps.back().after.base.translation();
      EXPECT_LE(std::hypot(end.x() - x, end.y() - y), 0.001) << name;
      EXPECT_LE(report.lower_bound, report.cost);
    }
}

TEST_F(Scenes, GreedyWalksOnlyWhatCanBeWalked) {
  for (const char* name : {"pillars", "doorway", "courtyard"}) {
    out_.steps.clear();
    plan(scene(name), request_to(0.3, 0.3), parameters({{"method", "greedy"}}));
    EXPECT_FALSE(out_.steps.empty());
  }
}

TEST_F(Scenes, AnObstacleBehindTheRobotChangesNothing) {
  Collector open;
  const Parameters values = parameters();
  const PlanReport without = planner().plan(request_to(0.2, 0.2), values, *planner().prepare({}, values), open);
  const std::string path = testing::TempDir() + "/far-away.yaml";
  std::ofstream(path) << "kind: plane\nobstacles:\n  - {name: far away, polygon: [[9, 9], [9.1, 9], [9, 9.1]]}\n";
  const PlanReport with = plan({"far", "", "yaml", path}, request_to(0.2, 0.2), values);
  EXPECT_NEAR(with.cost, without.cost, 1e-12);
  EXPECT_TRUE(with.optimal);
  EXPECT_EQ(out_.steps.size(), open.steps.size());
}

TEST_F(Scenes, ProvesThatAWallCostsCycles) {
  // Straight it is 0.55 m, six cycles; round the courtyard no walk is shorter than a point's way.
  const PlanReport report = plan(scene("courtyard"), request_to(0.0, 0.55), parameters({{"method", "fewest"}}));
  EXPECT_GE(report.lower_bound, 11.0);
}

TEST_F(Scenes, SaysSoWhenNoWayLeadsToTheGoal) {
  const std::string path = testing::TempDir() + "/closed.yaml";
  std::ofstream(path) << "kind: plane\nobstacles:\n"
                         "  - {name: south, polygon: [[0.3, 0.3], [0.9, 0.3], [0.9, 0.35], [0.3, 0.35]]}\n"
                         "  - {name: north, polygon: [[0.3, 0.85], [0.9, 0.85], [0.9, 0.9], [0.3, 0.9]]}\n"
                         "  - {name: west, polygon: [[0.3, 0.3], [0.35, 0.3], [0.35, 0.9], [0.3, 0.9]]}\n"
                         "  - {name: east, polygon: [[0.85, 0.3], [0.9, 0.3], [0.9, 0.9], [0.85, 0.9]]}\n";
  const PlanReport report =
      plan({"closed", "", "yaml", path}, request_to(0.6, 0.6), parameters({{"max_nodes", "500"}, {"max_pairs", "20000"}}));
  EXPECT_EQ(report.outcome, PlanReport::Outcome::kPartial);
  EXPECT_EQ(report.error, PlanError::kNoPath);
}

TEST_F(Scenes, RefusesAStartThatTouches) {
  Request request = request_to(0.4, 0.4);
  request.start.base = Isometry3d(Eigen::Translation3d(0.15, 0.10, 0.0));
  const Parameters values = parameters();
  const auto prepared = planner().prepare(scene("pillars"), values);
  try {
    planner().start(request, values, *prepared);
    FAIL() << "accepted";
  } catch (const InvalidRequest& fault) {
    EXPECT_EQ(fault.field(), "start.base");
    EXPECT_NE(std::string(fault.what()).find("pillar 1"), std::string::npos) << fault.what();
  }
}

TEST_F(Scenes, RefusesScenesThatAreNoPlanes) {
  EXPECT_THROW(planner().prepare({"x", "", "stl", "/tmp/x.stl"}, parameters()), InvalidScene);
}

// A flat outline would lie under the robot's bodies, and none of them would be seen to cut it.
TEST_F(Scenes, DrawsItsObstaclesAsWallsAndARoofAsHighAsTheRobot) {
  const auto prepared = planner().prepare(scene("doorway"), parameters());
  const std::vector<Shape> shapes = prepared->shapes();
  ASSERT_EQ(shapes.size(), 10u);
  double highest = 0.0;
  for (const Shape& body : planner().shapes(planner().start(request_to(0.0, 0.55), parameters(), *prepared)))
    highest =
        std::max(highest, body.pose.translation().z() + (body.kind == Shape::Kind::kBox ? body.size.z() / 2.0 : body.size.x()));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    EXPECT_EQ(shapes[i].kind, Shape::Kind::kPolygon);
    EXPECT_EQ(shapes[i].body, i < 5 ? "left wall" : "right wall");
    ASSERT_EQ(shapes[i].vertices.size(), 4u);
    const bool roof = i % 5 == 4;
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(shapes[i].vertices[k].z(), roof || k >= 2 ? highest : 0.0, 1e-12);
  }
}

TEST_F(Scenes, StopsAmongObstacles) {
  const Parameters values = parameters();
  const auto prepared = planner().prepare(scene("courtyard"), values);
  std::stop_source stop;
  stop.request_stop();
  out_.stop = stop.get_token();
  EXPECT_EQ(planner().plan(request_to(0.0, 0.55), values, *prepared, out_).outcome, PlanReport::Outcome::kStopped);
}

}  // namespace
}  // namespace foothold::xrobin
