// Motions: what Judge certifies holds at every sampled instant, and it certifies most of what keeps twice the margin.
#include <gtest/gtest.h>

#include "reference.hpp"

namespace foothold::bioloid {
namespace {

using namespace testing;

// The least room of any instant among `samples` + 1.
double least_room(const Joints& a, const Joints& b, const Support& support, const Demands& demands, int samples,
                  const std::vector<Prism>& prisms = {}) {
  double least = 1e9;
  for (int k = 0; k <= samples; ++k) {
    const double t = static_cast<double>(k) / samples;
    least = std::min(least, room(figures(shipped_model(), a + t * (b - a), support, prisms), demands, support.both));
    if (least < 0.0) break;
  }
  return least;
}

Demands twice(Demands d) {
  d.clearance *= 2.0;
  d.balance *= 2.0;
  d.ground = -1e-3;
  return d;
}

TEST(BioloidJudge, WhatItCertifiesHoldsAllTheWay) {
  const Model& model = shipped_model();
  Judge judge(model, {});
  const Demands demands = judge.demands(), strict = twice(demands);
  Draw draw{std::mt19937_64(5)};
  int certified = 0, refused = 0, easy = 0, timid = 0;
  for (int i = 0; i < 1500; ++i) {
    Support support;
    support.foot = i % 2 ? Side::kLeft : Side::kRight;
    const double wild = 0.03 * (i % 6);
    const Joints a = walking(model, support.foot, draw, wild), b = walking(model, support.foot, draw, wild);
    const bool good = judge.motion(a, b, support) == Fault::kNone;
    (good ? certified : refused) += 1;
    if (good) {
      ASSERT_GE(least_room(a, b, support, demands, 100), -1e-9) << i;
    }
    if (least_room(a, b, support, strict, 40) >= 0.0) {
      ++easy;
      timid += !good;
    }
  }
  EXPECT_GT(certified, 150);
  EXPECT_GT(refused, 150);
  EXPECT_GT(easy, 50);
  EXPECT_LT(timid, easy / 20 + 1);
}

}  // namespace
}  // namespace foothold::bioloid
