// Footsteps: as few as a search by breadth finds that knows no bounds, exact at the goal, within what a step may do.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <tuple>

#include "bioloid/steps/footsteps.hpp"

namespace foothold::bioloid::testing {
namespace {

constexpr double kHalf = 0.0385;

// Nothing but `accept` is asked.
Acceptance only(std::function<bool(const Placing&)> accept) {
  return {[](const PlanarPose&) { return false; }, [](Side, const PlanarPose&) { return false; }, std::move(accept)};
}
const Acceptance kAll{[](const PlanarPose&) { return true; }, [](Side, const PlanarPose&) { return true; },
                      [](const Placing&) { return false; }};

// A route, and the least one below it.
Footsteps least_of_all(const Feet& start, const PlanarPose& goal, const StepOptions& options, const Acceptance& acceptance) {
  Footsteps found = find_footsteps(start, {goal, false}, kHalf, options, acceptance);
  if (found.end != Footsteps::End::kFound) return found;
  Footsteps least = least_footsteps(start, {goal, false}, kHalf, options, found.steps.size(), 1'000'000, acceptance);
  if (least.end == Footsteps::End::kFound) return least;
  EXPECT_EQ(least.end, Footsteps::End::kNone);
  found.least = least.least;
  return found;
}

Feet feet_at(const PlanarPose& base) { return {sole_at(Side::kRight, base, kHalf), sole_at(Side::kLeft, base, kHalf)}; }

StepOptions coarse() {
  StepOptions out;
  out.cell = 0.02;
  out.length = 0.05;
  out.back = 0.03;
  out.width = 0.03;
  return out;
}

// Breadth first over the same lattice, written from the definition: poses by their cells, no bound, no order. The number of
// placements, or nothing within `most`. Start and goal on the lattice.
std::optional<int> by_breadth(const PlanarPose& goal, const StepOptions& options, int most,
                              const std::function<bool(const Placing&)>& accept) {
  using State = std::tuple<int, int, int, int>;  // side that stands, i, j, heading
  const int headings = static_cast<int>(std::lround(2.0 * M_PI / options.heading));
  const auto pose = [&](const State& s) {
    return PlanarPose{std::get<1>(s) * options.cell, std::get<2>(s) * options.cell, wrapped(std::get<3>(s) * options.heading)};
  };
  const auto at_goal = [&](const State& s) {
    return distance(pose(s), goal) < 1e-9 && std::abs(wrapped(pose(s).heading - goal.heading)) < 1e-9;
  };
  std::map<State, int> known{{{0, 0, 0, 0}, 0}, {{1, 0, 0, 0}, 0}};
  std::vector<State> wave{{0, 0, 0, 0}, {1, 0, 0, 0}};
  for (int depth = 1; depth <= most; ++depth) {
    std::vector<State> next;
    for (const State& at : wave) {
      const Side support = static_cast<Side>(std::get<0>(at)), moves = other(support);
      const PlanarPose sole = sole_at(support, pose(at), kHalf);
      for (int h = 0; h < headings; ++h)
        for (int i = std::get<1>(at) - 4; i <= std::get<1>(at) + 4; ++i)
          for (int j = std::get<2>(at) - 4; j <= std::get<2>(at) + 4; ++j) {
            const State to{static_cast<int>(moves), i, j, h};
            PlanarPose seen = relative(pose(at), pose(to));
            seen.heading = wrapped(seen.heading);
            if (!within_step(support, seen, options)) continue;
            PlanarPose place = relative(sole, sole_at(moves, pose(to), kHalf));
            place.heading = wrapped(place.heading);
            if (!accept({support, sole, place})) continue;
            if (at_goal(at) && at_goal(to)) return depth;
            if (known.emplace(to, depth).second) next.push_back(to);
          }
    }
    wave = std::move(next);
  }
  return std::nullopt;
}

TEST(Footsteps, AreAsFewAsBreadthFirstSearchFinds) {
  std::mt19937_64 random(5);
  const StepOptions options = coarse();
  const auto cell = [&](int most) { return std::uniform_int_distribution<int>(-most, most)(random); };
  int found = 0;
  for (int k = 0; k < 12; ++k) {
    const PlanarPose goal{cell(5) * options.cell, cell(4) * options.cell, wrapped(cell(5) * options.heading)};
    // Patches of ground that no sole's centre may come to.
    std::vector<Eigen::Vector2d> holes;
    for (int hole = 0; hole < k % 4; ++hole) holes.emplace_back(cell(5) * options.cell, cell(5) * options.cell);
    const auto accept = [&](const Placing& placing) {
      const PlanarPose sole = placing.sole * placing.place;
      for (const auto& hole : holes)
        if ((hole - Eigen::Vector2d(sole.x, sole.y)).norm() < 0.025) return false;
      return true;
    };
    const Footsteps ours = least_of_all(feet_at({}), goal, options, only(accept));
    const auto least = by_breadth(goal, options, 7, accept);
    if (least) {
      ASSERT_EQ(ours.end, Footsteps::End::kFound) << k;
      EXPECT_EQ(ours.steps.size(), static_cast<std::size_t>(*least)) << k;
      EXPECT_EQ(ours.least, ours.steps.size());
      ++found;
    } else if (ours.end == Footsteps::End::kFound && !ours.steps.empty()) {
      EXPECT_GT(ours.steps.size(), 7u) << k;
    }
  }
  EXPECT_GE(found, 7);
}

TEST(Footsteps, EndExactlyOnAGoalOffTheLattice) {
  const PlanarPose goal{0.2137, -0.0461, 0.3};
  const Footsteps found = find_footsteps(feet_at({}), {goal, false}, kHalf, {}, kAll);
  ASSERT_EQ(found.end, Footsteps::End::kFound);
  Feet feet = feet_at({});
  for (const Footstep& step : found.steps) feet.of(step.foot) = step.sole;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    EXPECT_LT(distance(base_of(side, feet.of(side), kHalf), goal), 1e-12);
    EXPECT_NEAR(feet.of(side).heading, goal.heading, 1e-12);
  }
}

TEST(Footsteps, AlternateAndKeepWithinAStep) {
  const StepOptions options;
  const Footsteps found = find_footsteps(feet_at({0.3, 0.2, 1.0}), {{-0.1, 0.5, -2.0}, false}, kHalf, options, kAll);
  ASSERT_EQ(found.end, Footsteps::End::kFound);
  Feet feet = feet_at({0.3, 0.2, 1.0});
  for (std::size_t k = 0; k < found.steps.size(); ++k) {
    const Footstep& step = found.steps[k];
    if (k > 0) {
      EXPECT_NE(step.foot, found.steps[k - 1].foot);
    }
    const Side support = other(step.foot);
    PlanarPose seen = relative(base_of(support, feet.of(support), kHalf), base_of(step.foot, step.sole, kHalf));
    seen.heading = wrapped(seen.heading);
    EXPECT_TRUE(within_step(support, seen, options)) << k;
    feet.of(step.foot) = step.sole;
  }
}

TEST(Footsteps, NeedNoneWhereTheRobotStandsAlready) {
  const Footsteps found =
      find_footsteps(feet_at({0.1, 0.2, 0.3}), {{0.1, 0.2, 0.3}, false}, kHalf, {}, only([](const Placing&) { return false; }));
  EXPECT_EQ(found.end, Footsteps::End::kFound);
  EXPECT_TRUE(found.steps.empty());
}

TEST(Footsteps, TakeAnyHeadingIfAsked) {
  const Footsteps turned = find_footsteps(feet_at({}), {{0.3, 0.0, M_PI / 2}, false}, kHalf, {}, kAll);
  const Footsteps straight = find_footsteps(feet_at({}), {{0.3, 0.0, M_PI / 2}, true}, kHalf, {}, kAll);
  ASSERT_EQ(straight.end, Footsteps::End::kFound);
  EXPECT_EQ(straight.steps.size(), 7u) << "six of 50 mm and one to close";
  EXPECT_GE(turned.steps.size(), straight.steps.size());
}

TEST(Footsteps, SayThatThereIsNoWay) {
  const auto wall = [](const Placing& placing) { return (placing.sole * placing.place).x < 0.1; };
  StepOptions options = coarse();
  options.most_nodes = 3000;
  EXPECT_EQ(find_footsteps(feet_at({}), {{0.3, 0.0, 0.0}, false}, kHalf, options, only(wall)).end, Footsteps::End::kTooMany);
  const auto nowhere = [](const Placing&) { return false; };
  EXPECT_EQ(find_footsteps(feet_at({}), {{0.3, 0.0, 0.0}, false}, kHalf, options, only(nowhere)).end, Footsteps::End::kNone);
}

TEST(Footsteps, StopWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  const Footsteps found = find_footsteps(feet_at({}), {{40.0, 0.0, 0.0}, false}, kHalf, {}, kAll, stop.get_token());
  EXPECT_EQ(found.end, Footsteps::End::kStopped);
}

}  // namespace
}  // namespace foothold::bioloid::testing
