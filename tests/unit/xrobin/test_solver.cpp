// Proved words: against brute force, against themselves, and what a proof must say.
#include <gtest/gtest.h>

#include <random>

#include "fixtures.hpp"
#include "solver.hpp"

namespace foothold::xrobin {
namespace {

Target random_target(std::mt19937_64& random, double radius) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double angle = 2.0 * std::numbers::pi * unit(random);
  const double r = radius * std::sqrt(unit(random));
  return {r * std::cos(angle), r * std::sin(angle), std::nullopt, 0.0};
}

double end_distance(const Mechanism& m, const Solution& solution, const Target& goal) {
  const PlanarPose end = forward(m, solution.word);
  return std::hypot(end.x - goal.x, end.y - goal.y);
}

TEST(Solver, AgreesWithBruteForceUpToThreeCycles) {
  for (const Mechanism& m : {mechanism(), Mechanism(with_exact_turns(0.103, 0.130)), Mechanism({0.02, 0.1, 0.105, 0.135})}) {
    Solver solver(m);
    std::mt19937_64 random(3);
    for (int cycles = 1; cycles <= 3; ++cycles) {
      solver.prepare(Method::kOptimal, cycles, 0, false, {});
      const Limits limits{.cycles = cycles, .max_cycles = cycles, .tolerance = 1e-9};
      for (int k = 0; k < 40; ++k) {
        Target goal = random_target(random, 1.2 * cycles * m.longest_cycle());
        if (k % 2 == 1) goal.heading = (k % 16 / 2 - 3) * std::numbers::pi / 4.0, goal.heading_tolerance = 0.01;
        const std::optional<BestWord> best = best_of_all_words(m, cycles, goal, {});
        const Solution found = solver.solve(Method::kOptimal, goal, limits, {});
        ASSERT_EQ(found.possible, best.has_value());
        if (!best) continue;
        EXPECT_NEAR(found.distance, best->distance, 1e-11) << cycles << " " << k;
        EXPECT_LE(found.least_distance, best->distance);
        EXPECT_GT(found.least_distance, found.distance - 1e-9);
        EXPECT_NEAR(end_distance(m, found, goal), found.distance, 1e-12);
        EXPECT_LE(found.word.size(), 2u * static_cast<std::size_t>(cycles));
      }
    }
  }
}

TEST(Solver, IsNeverWorseThanGreedyAndFarBetterInTheMedian) {
  const Mechanism m = mechanism();
  Solver solver(m);
  solver.prepare(Method::kOptimal, 7, 0, false, {});
  solver.prepare(Method::kGreedy, 7, 201, false, {});
  std::mt19937_64 random(5);
  const Limits limits{.cycles = 7, .max_cycles = 7, .tolerance = 1e-9};
  std::vector<double> ours, papers;
  for (int k = 0; k < 100; ++k) {
    const Target goal = random_target(random, 0.5);
    ours.push_back(solver.solve(Method::kOptimal, goal, limits, {}).distance);
    papers.push_back(solver.solve(Method::kGreedy, goal, limits, {}).distance);
    EXPECT_LE(ours.back(), papers.back() + 1e-12);
  }
  std::nth_element(ours.begin(), ours.begin() + 50, ours.end());
  std::nth_element(papers.begin(), papers.begin() + 50, papers.end());
  EXPECT_LT(ours[50], 0.1 * papers[50]);
}

TEST(Solver, FewestIsTheFirstNumberOfCyclesWhoseOptimumMeetsTheTolerance) {
  const Mechanism m = mechanism();
  Solver solver(m);
  solver.prepare(Method::kFewest, 6, 0, false, {});
  std::mt19937_64 random(11);
  for (int k = 0; k < 60; ++k) {
    const Target goal = random_target(random, 0.35);
    const Limits limits{.cycles = 6, .max_cycles = 6, .tolerance = 2e-3};
    const Solution fewest = solver.solve(Method::kFewest, goal, limits, {});
    int expected = 7;
    for (int cycles = 6; cycles >= 1; --cycles) {
      const Solution best = solver.solve(Method::kOptimal, goal, {.cycles = cycles, .max_cycles = cycles, .tolerance = 1e-9}, {});
      if (best.distance <= limits.tolerance) expected = cycles;
    }
    if (expected == 7) {
      EXPECT_GT(fewest.distance, limits.tolerance);
      continue;
    }
    EXPECT_EQ(fewest.word.size(), 2u * static_cast<std::size_t>(expected));
    EXPECT_EQ(fewest.least_cycles, expected);
    EXPECT_LE(end_distance(m, fewest, goal), limits.tolerance);
  }
}

TEST(Solver, TakesTheFewestCyclesAmongEquallyGoodWords) {
  const Mechanism m = mechanism();
  Solver solver(m);
  solver.prepare(Method::kOptimal, 6, 0, false, {});
  const Word three{2, 5, 8, 3, 1, 6};
  const PlanarPose end = forward(m, three);
  const Solution found =
      solver.solve(Method::kOptimal, {end.x, end.y, {}, 0.0}, {.cycles = 6, .max_cycles = 6, .tolerance = 1e-9}, {});
  EXPECT_LT(found.distance, 1e-11);
  EXPECT_LE(found.word.size(), three.size());
}

TEST(Solver, PutsFewCyclesBeforeTheLastSearchWhenTheGoalIsFar) {
  const Mechanism m = mechanism();
  Solver solver(m);
  solver.prepare(Method::kOptimal, 6, 0, false, {});
  std::mt19937_64 random(17);
  for (int k = 0; k < 20; ++k) {
    Target goal = random_target(random, 0.5);
    goal.x += 2.0;
    const Limits limits{.cycles = 6, .max_cycles = 60, .tolerance = 1e-3};
    for (const Method method : {Method::kOptimal, Method::kFewest}) {
      const Solution found = solver.solve(method, goal, limits, {});
      EXPECT_LE(end_distance(m, found, goal), limits.tolerance);
      const auto cycles = static_cast<int>(found.word.size() / 2);
      EXPECT_GE(cycles, found.least_cycles);
      EXPECT_LE(cycles, found.least_cycles + found.least_cycles / 2 + 4);
    }
  }
}

TEST(Solver, StopsWithinASearch) {
  Solver solver(mechanism());
  solver.prepare(Method::kOptimal, 6, 0, false, {});
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(solver.solve(Method::kOptimal, {0.2, 0.1, {}, 0.0}, {.cycles = 6}, stop.get_token()).stopped);
}

}  // namespace
}  // namespace foothold::xrobin
