// The leg without angles is the leg with angles, and nothing moves faster than its bounds say.
#include <gtest/gtest.h>

#include "octopod/transition/leg_shape.hpp"
#include "robot.hpp"

namespace foothold::octopod {
namespace {

// Left front leg of module A: out is +Y, forth is +X.
Vector3d in_module(const FromShoulder& at) { return octopod().shoulders[0] + Vector3d(at.forth, at.out, at.up); }

FromShoulder random_foot(std::mt19937_64& random) {
  const Vector3d v = random_vector(random, 0.2);
  return {v.x(), v.y(), v.z()};
}

TEST(OctopodLegShape, TheKneeIsWhereTheJointsPutIt) {
  std::mt19937_64 random(1);
  Model with_coxa = octopod();
  with_coxa.coxa = 0.02;
  int legs = 0;
  for (const Model& model : {octopod(), with_coxa})
    for (int i = 0; i < 20000; ++i) {
      const FromShoulder foot = random_foot(random);
      if (!may_be(model, foot, foot.out < 0 ? -1.0 : 1.0)) continue;
      ++legs;
      const auto joints = natural_leg(model, 0, in_module(foot));
      ASSERT_TRUE(joints);
      EXPECT_LT((leg_in_module(model, 0, *joints).knee - in_module(knee(model, foot))).norm(), 1e-12);
    }
  EXPECT_GT(legs, 10000);
}

TEST(OctopodLegShape, WhatMayBeAtBothEndsMayBeBetween) {
  std::mt19937_64 random(2);
  int ways = 0;
  for (int i = 0; i < 20000; ++i) {
    const FromShoulder a = random_foot(random), b = random_foot(random);
    const double sign = a.out < 0 ? -1.0 : 1.0, slack = uniform(random, 0, 0.01);
    if (!may_be_between(octopod(), a, b, sign, slack)) continue;
    ++ways;
    for (int k = 0; k <= 20; ++k) {
      const Vector3d off = random_vector(random, 1.0).normalized() * slack * 0.999;
      const FromShoulder at = between(a, b, k / 20.0), moved{at.out + off.x(), at.forth + off.y(), at.up + off.z()};
      EXPECT_TRUE(natural_leg(octopod(), 0, in_module(moved)));
      EXPECT_EQ(moved.out < 0, sign < 0) << "the leg would swing through";
    }
  }
  EXPECT_GT(ways, 1000);
}

TEST(OctopodLegShape, TheKneeIsNeverFasterThanItsRate) {
  std::mt19937_64 random(3);
  int ways = 0;
  double tightest = 0.0;
  for (int i = 0; i < 40000; ++i) {
    const FromShoulder a = random_foot(random), step = random_foot(random);
    const double size = uniform(random, 0.005, 0.3);
    const FromShoulder b{a.out + size * step.out, a.forth + size * step.forth, a.up + size * step.up};
    if (!may_be_between(octopod(), a, b, a.out < 0 ? -1.0 : 1.0, 0.0)) continue;
    ++ways;
    const double rate = knee_rate(octopod(), a, b);
    for (int k = 0; k < 20; ++k) {
      const FromShoulder p = between(a, b, k / 20.0), q = between(a, b, (k + 1) / 20.0);
      const double is = apart(knee(octopod(), p), knee(octopod(), q)) / apart(p, q);
      EXPECT_LE(is, rate * (1 + 1e-9));
      tightest = std::max(tightest, is / rate);
    }
  }
  EXPECT_GT(ways, 5000);
  EXPECT_GT(tightest, 0.3) << "a bound that says nothing";
}

}  // namespace
}  // namespace foothold::octopod
