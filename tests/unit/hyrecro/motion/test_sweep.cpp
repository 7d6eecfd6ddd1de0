// The bounds of the bodies' displacements against random ways, and how tight they are.
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.hpp"
#include "hyrecro/motion/sweep.hpp"

namespace foothold::hyrecro {
namespace {

using testing::shipped_model;
using testing::uniform;

Actuators random_actuators(std::mt19937_64& random) {
  Actuators out;
  for (int i = 0; i < 8; ++i) out[i] = uniform(random, shipped_model().mechanism.shortest(), shipped_model().mechanism.longest());
  for (int i = 8; i < 10; ++i) out[i] = uniform(random, -3.1, 3.1);
  return out;
}

double moved(const collision::Capsule& a, const collision::Capsule& b) { return std::max((a.a - b.a).norm(), (a.b - b.b).norm()); }

double moved(const collision::Box& a, const collision::Box& b) {
  double most = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d at = a.half.cwiseProduct(Vector3d(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0));
    most = std::max(most, (a.pose * at - b.pose * at).norm());
  }
  return most;
}

// A box seen from the hip plate.
collision::Box seen_from(const collision::Box& hip, collision::Box box) {
  box.pose = hip.pose.inverse() * box.pose;
  return box;
}

TEST(Sweep, IsNeverExceededByAnyBodyOnRandomWays) {
  const Model& model = shipped_model();
  std::mt19937_64 random(11);
  int bounded = 0;
  for (int n = 0; n < 100'000; ++n) {
    const Actuators a = random_actuators(random), other = random_actuators(random);
    const double length = std::pow(10.0, uniform(random, -4.0, 0.0));
    const Actuators b = a + length * (other - a);
    const Coordinates middle = from_actuators(model, 0.5 * (a + b));
    const Sweep bound = sweep(model, a, b, middle);
    const Bodies here = bodies_at(model, middle, Isometry3d::Identity());
    const Bodies there = bodies_at(model, from_actuators(model, a + uniform(random, 0.0, 1.0) * (b - a)), Isometry3d::Identity());
    constexpr double rounding = 1e-12;
    ASSERT_LE(moved(here.leg[0], there.leg[0]), bound.leg0 + rounding) << n;
    ASSERT_LE(moved(here.hip, there.hip), bound.hip + rounding) << n;
    ASSERT_LE(moved(here.leg[1], there.leg[1]), bound.leg1 + rounding) << n;
    ASSERT_LE(moved(here.plate[1], there.plate[1]), bound.plate1 + rounding) << n;
    ASSERT_LE(moved(seen_from(here.hip, here.plate[1]), seen_from(there.hip, there.plate[1])), bound.plate1_about_hip + rounding)
        << n;
    ASSERT_LE(std::fabs(distance(here.leg[0], here.leg[1]) - distance(there.leg[0], there.leg[1])), bound.legs + rounding) << n;
    bounded += std::isfinite(bound.plate1) ? 1 : 0;
  }
  EXPECT_GT(bounded, 70'000);
}

}  // namespace
}  // namespace foothold::hyrecro
