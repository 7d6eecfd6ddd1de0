// The best posture against exhaustive search on a grid, its bound against random poses, and against the paper's strategies over the
// whole plane of slopes and directions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "../slopes.hpp"
#include "hexpiderix/optimal/best_posture.hpp"
#include "hexpiderix/optimal/pose_bound.hpp"
#include "hexpiderix/optimal/support_frame.hpp"

namespace foothold::hexpiderix::testing {
namespace {

Evaluation evaluated(const Situation& from, const Isometry3d& thorax) {
  return evaluate(shipped_model(), from.ground, from.footholds, thorax, {shipped_model().lift, true}, from.clearance);
}

PoseVector random_in(const PoseVector& middle, const PoseVector& half, std::mt19937_64& random) {
  std::uniform_real_distribution<double> part(-1, 1);
  PoseVector out{};
  for (std::size_t k = 0; k < 6; ++k) out[k] = middle[k] + part(random) * half[k];
  return out;
}

TEST(PoseBound, NoPoseOfABoxIsBetterThanItsBound) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> slope(0, 70), direction(0, 360), size(-6, 0);
  const Legs sets[] = {kTriad1, kTriad2, Legs{0b110110}, Legs{0b111111}, Legs{0b110100}};
  int valid = 0, near = 0;
  for (int i = 0; i < 3'000; ++i) {
    const Situation from = tilted(slope(random) * kDegree, direction(random) * kDegree, sets[i % 5]);
    const PoseBound bound(shipped_model(), from.ground, from.footholds, support_frame(from), from.clearance);
    const PoseVector middle = random_in({0, 0, 0.09, 0, 0, 0}, {0.06, 0.06, 0.07, 0.6, 0.6, 0.3}, random);
    PoseVector half{};
    for (std::size_t k = 0; k < 6; ++k) half[k] = (k < 3 ? 0.08 : 0.6) * std::exp2(size(random));
    const auto most = bound(middle, half);
    for (int j = 0; j < 40; ++j) {
      const Evaluation found = evaluated(from, bound.pose(random_in(middle, half, random)));
      if (!found.valid()) continue;
      ++valid;
      ASSERT_TRUE(most) << "a posture in a box that was said to hold none";
      ASSERT_LE(found.nesm, *most + 1e-12);
      near += found.nesm > *most - 5e-3;
    }
  }
  EXPECT_GT(valid, 10'000);
  EXPECT_GT(near, 200) << "the bound is not just a great number";
}

TEST(BestPosture, EqualsTheBestOfAllPosesOfTheGrid) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> slope(0, 70), direction(0, 360);
  BestOptions options;
  options.grid.along = options.grid.across = {-0.05, 0.05, 0.025};
  options.grid.height = {0.03, 0.15, 0.03};
  options.grid.roll = options.grid.pitch = {-0.5, 0.5, 0.25};
  options.grid.yaw = {-0.2, 0.2, 0.2};
  const PoseGrid& grid = options.grid;
  for (int i = 0; i < 12; ++i) {
    const Situation from = tilted(slope(random) * kDegree, direction(random) * kDegree, i % 3 ? kTriad1 : Legs{0b110110});
    const PoseBound frame(shipped_model(), from.ground, from.footholds, support_frame(from), from.clearance);
    double best = -std::numeric_limits<double>::infinity();
    for (int a = 0; a < grid.along.count(); ++a)
      for (int b = 0; b < grid.across.count(); ++b)
        for (int c = 0; c < grid.height.count(); ++c)
          for (int d = 0; d < grid.roll.count(); ++d)
            for (int e = 0; e < grid.pitch.count(); ++e)
              for (int f = 0; f < grid.yaw.count(); ++f) {
                const Evaluation found = evaluated(from, frame.pose({grid.along.at(a), grid.across.at(b), grid.height.at(c),
                                                                     grid.roll.at(d), grid.pitch.at(e), grid.yaw.at(f)}));
                if (found.valid()) best = std::max(best, found.nesm);
              }
    const BestPosture found = best_posture(shipped_model(), from, options, {});
    ASSERT_EQ(found.end, BestPosture::End::kProved);
    EXPECT_DOUBLE_EQ(found.on_grid.nesm, best);
    EXPECT_GE(found.polished.nesm, best);
  }
}

TEST(BestPosture, OverThePlaneOfSlopesIsNeverBelowTheStrategies) {
  const bool whole = std::getenv("FOOTHOLD_LONG") != nullptr;
  const double slope_step = whole ? 1 : 7.5, direction_step = whole ? 1 : 20;
  int count = 0, positive_at_60 = 0, at_60 = 0;
  double least_gain = 1.0, gain = 0.0, most_friction = 0.0;
  for (double slope = 0; slope <= 60.0; slope += slope_step)
    for (double direction = 0; direction < 360; direction += direction_step)
      for (const Legs triad : {kTriad1, kTriad2}) {
        const Situation from = tilted(slope * kDegree, direction * kDegree, triad);
        double strategies = -std::numeric_limits<double>::infinity();
        for (const Adapted& adapted : {constant_orientation(shipped_model(), from), geometric(shipped_model(), from)})
          if (adapted.evaluation.valid()) strategies = std::max(strategies, adapted.evaluation.nesm);
        const BestPosture found = best_posture(shipped_model(), from, {}, {});
        ASSERT_EQ(found.end, BestPosture::End::kProved) << slope << " towards " << direction;
        ASSERT_GE(found.polished.nesm, strategies) << slope << " towards " << direction;
        // Emergency stands on a fourth leg, so it is compared with the best posture on the same legs.
        const Adapted fourth = emergency(shipped_model(), from, EmergencyRule::kLongestDistance);
        if (fourth.evaluation.valid() && count % 7 == 0) {
          Situation on_four = from;
          on_four.footholds = fourth.footholds;
          ASSERT_GE(best_posture(shipped_model(), on_four, {}, {}).polished.nesm, fourth.evaluation.nesm);
        }
        ++count;
        if (std::isfinite(strategies)) {
          least_gain = std::min(least_gain, found.polished.nesm - strategies);
          gain += found.polished.nesm - strategies;
        }
        if (slope == 60.0) {
          ++at_60;
          positive_at_60 += found.polished.nesm > 0.0;
          most_friction = std::max(most_friction, friction_needed(from.footholds, found.polished.centre_of_mass));
        }
      }
  std::printf(
      "%d slopes: NESM above the better strategy's by %.1f mm at least, %.1f mm on average; at 60 deg positive on %d of %d, "
      "with friction up to %.2f\n",
      count, 1e3 * least_gain, 1e3 * gain / count, positive_at_60, at_60, most_friction);
  EXPECT_EQ(positive_at_60, at_60);
  EXPECT_GE(most_friction, std::tan(60 * kDegree) - 1e-6) << "a plane's slope cannot be held with less";
}

TEST(BestPosture, WithFrictionGivenItDoesNotSlide) {
  const Situation from = tilted(40 * kDegree, 0, kTriad1);
  BestOptions options;
  options.friction = std::tan(40 * kDegree) * 1.05;
  const BestPosture found = best_posture(shipped_model(), from, options, {});
  ASSERT_EQ(found.end, BestPosture::End::kProved);
  EXPECT_LE(friction_needed(from.footholds, found.polished.centre_of_mass), options.friction);
  options.friction = std::tan(40 * kDegree) * 0.95;
  EXPECT_FALSE(best_posture(shipped_model(), from, options, {}).polished.nesm > 0.0)
      << "no posture holds on a plane as steep as that";
}

TEST(StablePosture, WhatIsFoundStandsAndWhatIsProvedNotToExistIsNotFound) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> slope(50, 89), direction(0, 360);
  int found_some = 0, proved = 0;
  for (int i = 0; i < 24; ++i) {
    const Situation from = tilted(slope(random) * kDegree, direction(random) * kDegree, kTriad1);
    BestOptions options;
    options.most_boxes = 150'000;
    const Existence answer = stable_posture(shipped_model(), from, options, {});
    if (answer.answer == Existence::Answer::kFound) {
      ++found_some;
      EXPECT_GT(evaluated(from, answer.found.at.thorax).nesm, 0.0);
    }
    if (answer.answer != Existence::Answer::kProvedNone) continue;
    ++proved;
    const PoseBound frame(shipped_model(), from.ground, from.footholds, support_frame(from), from.clearance);
    for (int j = 0; j < 5'000; ++j) {
      const Evaluation other =
          evaluated(from, frame.pose(random_in({0, 0, 0.09, 0, 0, 0}, {0.06, 0.06, 0.07, 0.6, 0.6, 0}, random)));
      ASSERT_FALSE(other.valid() && other.nesm > 0.0);
    }
  }
  EXPECT_GE(found_some, 4);
  EXPECT_GE(proved, 4);
}

TEST(BestPosture, StopsWhenItIsToldTo) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(best_posture(shipped_model(), tilted(0.3, 0, kTriad1), {}, stop.get_token()).end, BestPosture::End::kStopped);
}

}  // namespace
}  // namespace foothold::hexpiderix::testing
