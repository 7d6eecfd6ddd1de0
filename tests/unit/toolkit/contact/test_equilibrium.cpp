// Equilibrium where the answer is known in closed form, and what the object promises about its use.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "contact/certificate.hpp"
#include "stances.hpp"

namespace foothold::contact {
namespace {

constexpr double kPi = std::numbers::pi;

// Feet at the corners of a square of 0.4 m on a plane that falls by `slope` along X; the centre of mass 0.2 m above its middle
// along the plane's normal.
Stance on_slope(double slope, double mu) {
  Stance out;
  const Eigen::AngleAxisd tilt(slope, Vector3d::UnitY());
  for (const double x : {-0.2, 0.2})
    for (const double y : {-0.2, 0.2}) out.contacts.push_back({tilt * Vector3d(x, y, 0.0), tilt * Vector3d::UnitZ()});
  out.com = tilt * Vector3d(0.0, 0.0, 0.2);
  out.mu = mu;
  return out;
}

bool stable(const Stance& s, FrictionCone cone) {
  Equilibrium equilibrium(cone);
  const Verdict& verdict = equilibrium.judge(s.contacts, s.com, s.mu);
  EXPECT_TRUE(proves(verdict, s.contacts, s.com, s.mu, cone));
  return verdict.stable;
}

TEST(Equilibrium, SlidesOnAPlaneSteeperThanTheCone) {
  EXPECT_TRUE(stable(on_slope(std::atan(0.4) - 1e-6, 0.4), FrictionCone::circular()));
  EXPECT_FALSE(stable(on_slope(std::atan(0.4) + 1e-6, 0.4), FrictionCone::circular()));
}

TEST(Equilibrium, APyramidHoldsNoMoreThanItsShape) {
  // On a plane falling along X the friction needed points along -t: towards an edge of an even pyramid, between two of an odd one.
  const auto holds = [](int edges, double slope) { return stable(on_slope(slope, 0.4), FrictionCone::pyramid(edges)); };
  EXPECT_TRUE(holds(10, std::atan(0.4) - 1e-6));
  EXPECT_FALSE(holds(10, std::atan(0.4) + 1e-6));
  const double odd = std::atan(0.4 * std::cos(kPi / 5.0));
  EXPECT_TRUE(holds(5, odd - 1e-6));
  EXPECT_FALSE(holds(5, odd + 1e-6));
}

TEST(Equilibrium, TopplesWhereTheCentreOfMassLeavesTheFeet) {
  Stance s = on_slope(0.0, 0.5);
  s.com.x() = 0.2 - 1e-6;
  EXPECT_TRUE(stable(s, FrictionCone::circular()));
  s.com.x() = 0.2 + 1e-6;
  EXPECT_FALSE(stable(s, FrictionCone::circular()));
  EXPECT_FALSE(stable(s, FrictionCone::pyramid(10)));
}

TEST(Equilibrium, StandsWithoutFrictionOnLevelGroundAlone) {
  EXPECT_TRUE(stable(on_slope(0.0, 0.0), FrictionCone::circular()));
  EXPECT_TRUE(stable(on_slope(0.0, 0.0), FrictionCone::pyramid(10)));
  EXPECT_FALSE(stable(on_slope(0.01, 0.0), FrictionCone::circular()));
}

TEST(Equilibrium, PressesAgainstTwoWalls) {
  // Two vertical walls hold a robot between them however steep they are, if the line between the contacts lies in both cones.
  Stance s;
  for (const double side : {-1.0, 1.0})
    for (const double y : {-0.1, 0.1}) s.contacts.push_back({{0.3 * side, y, 0.0}, {-side, 0.0, 0.0}});
  s.mu = 0.1;
  EXPECT_TRUE(stable(s, FrictionCone::circular()));
  s.com = {0.05, 0.05, -0.2};
  EXPECT_TRUE(stable(s, FrictionCone::circular()));
  s.mu = 0.0;
  EXPECT_FALSE(stable(s, FrictionCone::circular()));
}

TEST(Equilibrium, HangsOnNothing) {
  EXPECT_FALSE(stable({}, FrictionCone::circular()));
  EXPECT_FALSE(stable({}, FrictionCone::pyramid(3)));
  EXPECT_TRUE(stable({{{Vector3d(0.0, 0.0, -0.1), Vector3d::UnitZ()}}, Vector3d::Zero(), 0.3}, FrictionCone::circular()));
  EXPECT_FALSE(stable({{{Vector3d(0.0, 0.0, 0.1), -Vector3d::UnitZ()}}, Vector3d::Zero(), 0.3}, FrictionCone::circular()));
}

TEST(Equilibrium, DoesNotDependOnTheUnitOfLengthNorOnTheOrigin) {
  std::mt19937_64 random(4);
  for (int k = 0; k < 200; ++k) {
    const Stance s = random_stance(random);
    Stance far = s;
    for (Contact& c : far.contacts) c.point = 1000.0 * c.point + Vector3d(100.0, -50.0, 20.0);
    far.com = 1000.0 * far.com + Vector3d(100.0, -50.0, 20.0);
    EXPECT_EQ(stable(s, FrictionCone::pyramid(10)), stable(far, FrictionCone::pyramid(10)));
  }
}

TEST(Equilibrium, AnswersTheSameAfterForgetting) {
  std::mt19937_64 random(5);
  Equilibrium used(FrictionCone::pyramid(10));
  for (int k = 0; k < 200; ++k) {
    const Stance s = random_stance(random);
    Equilibrium fresh(FrictionCone::pyramid(10));
    used.forget();
    const Verdict& a = used.judge(s.contacts, s.com, s.mu);
    const Verdict& b = fresh.judge(s.contacts, s.com, s.mu);
    EXPECT_EQ(a.stable, b.stable);
    EXPECT_EQ(a.forces, b.forces);
    EXPECT_EQ(a.separating, b.separating);
  }
}

TEST(Equilibrium, JudgesStancesOfMoreThanEightContacts) {
  std::mt19937_64 random(6);
  int holding = 0;
  for (int k = 0; k < 200; ++k) holding += stable(random_stance(random, 9 + k % 20), FrictionCone::circular()) ? 1 : 0;
  EXPECT_GT(holding, 100);
}

TEST(Equilibrium, RefusesWhatIsNoStance) {
  EXPECT_THROW(Equilibrium(FrictionCone::pyramid(2)), std::invalid_argument);
  EXPECT_THROW(Equilibrium(FrictionCone::pyramid(-3)), std::invalid_argument);
  EXPECT_THROW(Equilibrium(FrictionCone::pyramid(1025)), std::invalid_argument);
  Equilibrium equilibrium(FrictionCone::circular());
  const Stance good = on_slope(0.1, 0.4);
  EXPECT_THROW(equilibrium.judge(good.contacts, good.com, -0.1), std::invalid_argument);
  EXPECT_THROW(equilibrium.judge(good.contacts, good.com, std::nan("")), std::invalid_argument);
  EXPECT_THROW(equilibrium.judge({}, Vector3d(0.0, std::nan(""), 0.0), 0.1), std::invalid_argument);
  Stance bad = good;
  bad.contacts[2].normal *= 1.01;
  EXPECT_THROW(equilibrium.judge(bad.contacts, bad.com, 0.4), std::invalid_argument);
  bad = good;
  bad.contacts[1].point.y() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(equilibrium.judge(bad.contacts, bad.com, 0.4), std::invalid_argument);
}

}  // namespace
}  // namespace foothold::contact
