// The friction a stance needs, against closed forms and against halving with CLP; the paper's Newton method against both.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "contact/certificate.hpp"
#include "contact/critical_friction.hpp"
#include "contact/newton.hpp"
#include "oracles.hpp"
#include "stances.hpp"

namespace foothold::contact {
namespace {

int stances() { return std::getenv("FOOTHOLD_LONG") != nullptr ? 20'000 : 200; }

TEST(CriticalFriction, OfATripodOnAPlaneIsItsSlope) {
  for (const double degrees : {0.5, 15.0, 30.0, 45.0, 60.0}) {
    const double slope = degrees * std::numbers::pi / 180.0;
    const Eigen::AngleAxisd tilt(slope, Vector3d(0.6, 0.8, 0.0));
    std::vector<Contact> tripod;
    for (const double turn : {0.0, 2.0, 4.0})
      tripod.push_back({tilt * Vector3d(0.2 * std::cos(turn), 0.2 * std::sin(turn), 0.0), tilt * Vector3d::UnitZ()});
    EXPECT_NEAR(critical_friction(tripod, Vector3d(0.0, 0.0, 0.05)), std::tan(slope), 2e-8) << degrees;
  }
}

TEST(CriticalFriction, IsZeroOnLevelGroundAndInfiniteBesideTheFeet) {
  const std::vector<Contact> tripod = {
      {{0.2, 0.0, 0.0}, Vector3d::UnitZ()}, {{-0.1, 0.1, 0.0}, Vector3d::UnitZ()}, {{-0.1, -0.1, 0.0}, Vector3d::UnitZ()}};
  Equilibrium equilibrium(FrictionCone::circular());
  const CriticalFriction level = critical_friction(equilibrium, tripod, {0.0, 0.0, 0.3});
  EXPECT_EQ(level.mu, 0.0);
  EXPECT_LT(level.not_at, 0.0);
  const CriticalFriction beside = critical_friction(equilibrium, tripod, {0.3, 0.0, 0.3});
  EXPECT_EQ(beside.mu, std::numeric_limits<double>::infinity());
  EXPECT_EQ(beside.not_at, kGreatestFriction);
  EXPECT_TRUE(beside.forces.empty());
}

TEST(CriticalFriction, IsBracketedByProofs) {
  for (const FrictionCone cone : {FrictionCone::circular(), FrictionCone::pyramid(10)}) {
    std::mt19937_64 random(12);
    Equilibrium equilibrium(cone);
    int wide = 0, finite = 0;
    for (int i = 0; i < 5 * stances(); ++i) {
      const Stance s = random_stance(random);
      const CriticalFriction critical = critical_friction(equilibrium, s.contacts, s.com);
      if (std::isfinite(critical.mu)) {
        ++finite;
        EXPECT_TRUE(proves({.stable = true, .proved = true, .forces = critical.forces}, s.contacts, s.com, critical.mu, cone));
      }
      if (critical.not_at < 0.0) continue;
      Verdict not_at{.proved = true};
      not_at.separating = critical.separating;
      EXPECT_TRUE(proves(not_at, s.contacts, s.com, critical.not_at, cone));
      wide += critical.mu - critical.not_at > 1.01e-8 * std::max(1.0, critical.mu) ? 1 : 0;
    }
    EXPECT_GT(finite, 4 * stances());
    EXPECT_LT(wide, stances() / 10);  // of five times as many
  }
}

TEST(CriticalFriction, IsWhereClpTurns) {
  std::mt19937_64 random(13);
  Equilibrium equilibrium(FrictionCone::pyramid(10));
  Clp clp;
  for (int i = 0; i < stances(); ++i) {
    Stance s = random_stance(random);
    const double critical = critical_friction(equilibrium, s.contacts, s.com).mu;
    const auto holds = [&](double mu) {
      s.mu = mu;
      return clp.holds(generators(s, 10), Wrench::Unit(2));
    };
    EXPECT_TRUE(critical == 0.0 || !holds(critical - 1e-4 * std::max(1.0, critical))) << i;
    EXPECT_TRUE(holds(critical + 1e-4 * std::max(1.0, critical))) << i;
  }
}

TEST(NewtonEquilibrium, FindsForcesInsideTheConesAndMissesFewStances) {
  std::mt19937_64 random(14);
  const FrictionCone cone = FrictionCone::pyramid(10);
  Equilibrium equilibrium(cone);
  NewtonEquilibrium newton({});
  int stable = 0, missed = 0;
  for (int i = 0; i < 5 * stances(); ++i) {
    const Stance s = random_stance(random);
    const bool holds = equilibrium.judge(s.contacts, s.com, s.mu).stable;
    const bool found = newton.stable(s.contacts, s.com, s.mu, random);
    stable += holds ? 1 : 0;
    missed += holds && !found ? 1 : 0;
    EXPECT_TRUE(holds || !found) << i;
    if (!found) continue;
    Vector3d force = -Vector3d::UnitZ(), torque = Vector3d::Zero();
    const std::vector<Vector3d> forces = newton.forces();
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const double normal = forces[k].dot(s.contacts[k].normal);
      EXPECT_LE((forces[k] - normal * s.contacts[k].normal).norm(), s.mu * normal + 1e-7);
      force += forces[k];
      torque += (s.contacts[k].point - s.com).cross(forces[k]);
    }
    EXPECT_LT(force.norm(), 1e-8);
    EXPECT_LT(torque.norm(), 1e-8);
  }
  EXPECT_GT(stable, stances());
  EXPECT_LT(missed, stable / 20);
}

TEST(NewtonEquilibrium, RefusesSettingsWithoutMeaning) {
  EXPECT_THROW(NewtonEquilibrium({.edges = 0}), std::invalid_argument);
  EXPECT_THROW(NewtonEquilibrium({.edges = 2}), std::invalid_argument);
  EXPECT_THROW(NewtonEquilibrium({.iterations = 0}), std::invalid_argument);
  EXPECT_THROW(NewtonEquilibrium({.starts = 0}), std::invalid_argument);
  EXPECT_THROW(NewtonEquilibrium({.tolerance = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace foothold::contact
