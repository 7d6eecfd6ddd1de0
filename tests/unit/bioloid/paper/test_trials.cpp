// The paper's demonstrations over many trials, before judges of their own; statistics; the choice of the best.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <queue>

#include "bioloid/paper/cases.hpp"
#include "bioloid/paper/trials.hpp"
#include "spaces.hpp"

namespace foothold::bioloid::paper::testing {
namespace {

constexpr auto kNoError = [](const Point&) { return 0.0; };

std::vector<Trial> hundred(const Case& shown, Method method) {
  std::mt19937_64 random(17);
  return trials(shown.space, shown.start, shown.goal, {.method = method}, 100, kNoError, random);
}

double mean_iterations(const std::vector<Trial>& of) {
  double out = 0.0;
  for (const Trial& trial : of) out += static_cast<double>(trial.plan.iterations) / static_cast<double>(of.size());
  return out;
}

// Fewest movements on the plane's grid, breadth first, by a reading of the paper's numbers of its own.
std::size_t fewest_movements() {
  std::map<std::pair<int, int>, std::size_t> reached{{{7, 17}, 0}};
  std::queue<std::pair<int, int>> open({{7, 17}});
  while (!reached.contains({5, 2})) {
    const auto [x, y] = open.front();
    open.pop();
    for (int u = x - 1; u <= x + 1; ++u)
      for (int v = y - 1; v <= y + 1; ++v) {
        const bool free = u >= 0 && u <= 10 && v >= 0 && v <= 20 && !(u >= 2 && u <= 9 && v >= 3 && v <= 12);
        if (free && reached.emplace(std::pair{u, v}, reached[{x, y}] + 1).second) open.emplace(u, v);
      }
  }
  return reached[{5, 2}];
}

// Every movement in a thousand parts, none of them in the obstacle.
void expect_round_the_obstacle(const std::vector<Point>& path) {
  for (std::size_t k = 1; k < path.size(); ++k)
    for (int part = 0; part <= 1000; ++part) {
      const Point at = path[k - 1] + part / 1000.0 * (path[k] - path[k - 1]);
      ASSERT_FALSE(at.x() >= 2.0 && at.x() <= 9.0 && at.y() >= 3.0 && at.y() <= 12.0) << at.transpose();
    }
}

TEST(Demonstrations, BothMethodsGoRoundTheObstacleInThePlaneAndInSpace) {
  const std::size_t fewest = fewest_movements();
  for (const Case& shown : {plane_case(), space_case()}) {
    double iterations[2];
    for (const Method method : {Method::kRandom, Method::kStochastic}) {
      const auto all = hundred(shown, method);
      for (const Trial& trial : all) {
        ASSERT_EQ(trial.plan.ending, Ending::kReached);
        expect_valid(shown.space, trial.plan.path, shown.start, shown.goal, 3.0);
        expect_round_the_obstacle(trial.plan.path);
        EXPECT_GE(3 * trial.plan.movements(), fewest);
        if (method == Method::kRandom) {
          EXPECT_GE(trial.plan.movements(), fewest);
        }
      }
      iterations[method == Method::kStochastic] = mean_iterations(all);
    }
    EXPECT_LT(10.0 * iterations[1], iterations[0]);
  }
}

TEST(Demonstrations, ThreeJointsStayWithinTheirAngles) {
  const Case shown = joints_case();
  const auto straight = hundred(shown, Method::kStochastic);
  for (const Trial& trial : straight) EXPECT_EQ(trial.plan.iterations, 20u) << "nothing is in the way";
  std::mt19937_64 random(17);
  for (const Trial& trial : trials(shown.space, shown.start, shown.goal, {.method = Method::kRandom}, 5, kNoError, random)) {
    ASSERT_EQ(trial.plan.ending, Ending::kReached);
    expect_valid(shown.space, trial.plan.path, shown.start, shown.goal);
    for (const Point& at : trial.plan.path) EXPECT_LT(at.cwiseAbs().maxCoeff(), 25.0);
    EXPECT_LT(10 * trial.plan.movements(), trial.plan.found_movements) << "Figure 7 beside Figure 6";
  }
}

TEST(Trials, MeanAndVarianceOfTheErrorAreOfThePathsPoints) {
  const Space space = grid(point({10}), [](const Point&) { return true; });
  std::mt19937_64 random(1);
  const auto all = trials(
      space, point({0}), point({4}), {}, 3, [](const Point& at) { return at.x() * at.x(); }, random);
  ASSERT_EQ(all.size(), 3u);
  // 0, 1, 4, 9, 16: mean 6, mean of the squares 354 / 5.
  EXPECT_NEAR(all[1].mean_error, 6.0, 1e-12);
  EXPECT_NEAR(all[1].error_variance, 354.0 / 5.0 - 36.0, 1e-12);
}

TEST(Trials, AreRepeatedByTheirSeedAndDifferAmongThemselves) {
  const Case shown = plane_case();
  const auto a = hundred(shown, Method::kRandom), b = hundred(shown, Method::kRandom);
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].plan.path, b[k].plan.path);
  EXPECT_NE(a[0].plan.iterations, a[1].plan.iterations);
}

TEST(Trials, TheBestIsByWhatIsAskedAmongThoseThatReached) {
  const auto trial = [](Ending ending, std::size_t iterations, double error, double variance) {
    Trial out;
    out.plan.ending = ending;
    out.plan.iterations = iterations;
    out.mean_error = error;
    out.error_variance = variance;
    return out;
  };
  const std::vector<Trial> all{trial(Ending::kCapped, 1, 0, 0), trial(Ending::kReached, 30, 2.0, 7.0),
                               trial(Ending::kReached, 10, 3.0, 6.0), trial(Ending::kReached, 10, 4.0, 5.0)};
  EXPECT_EQ(best(all, Choice::kFewestIterations), 2u);
  EXPECT_EQ(best(all, Choice::kLeastError), 1u);
  EXPECT_EQ(best(all, Choice::kLeastVariance), 3u);
  EXPECT_EQ(best({all[0]}, Choice::kLeastError), std::nullopt);
}

TEST(Trials, AreFewerWhenStopped) {
  std::stop_source stop;
  std::mt19937_64 random(1);
  const Case shown = plane_case();
  int errors = 0;
  const auto stopping = [&](const Point&) {
    if (++errors == 100) stop.request_stop();
    return 0.0;
  };
  const auto all = trials(shown.space, shown.start, shown.goal, {}, 100, stopping, random, stop.get_token());
  EXPECT_LT(all.size(), 8u);
  EXPECT_GT(all.size(), 1u);
}

}  // namespace
}  // namespace foothold::bioloid::paper::testing
