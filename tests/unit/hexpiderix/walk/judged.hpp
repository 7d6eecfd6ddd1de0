// A walk before the judge, half cycle by half cycle, as the host does.
#pragma once

#include <gtest/gtest.h>

#include "../slopes.hpp"
#include "hexpiderix/check/check.hpp"
#include "hexpiderix/steps.hpp"

namespace foothold::hexpiderix::testing {

inline void expect_sound(const Ground& ground, const Stand& from, const Walk& found, const WalkOptions& options) {
  const Stand* at = &from;
  int number = 0;
  for (const HalfCycle& half : found.half_cycles) {
    const Step step = to_step(shipped_model(), *at, half, ++number, 0.0);
    const StepVerdict verdict = check_step(shipped_model(), ground.surface(), step, standing_posture(at->at, at->feet),
                                           {options.clearance, options.friction, options.least_nesm});
    ASSERT_TRUE(verdict.accepted) << step.label << ": " << verdict.reason;
    for (const Margin& margin : verdict.margins) ASSERT_GE(margin.value, margin.least) << margin.name;
    EXPECT_GE(half.least_nesm, options.least_nesm);
    at = &half.to;
  }
}

}  // namespace foothold::hexpiderix::testing
