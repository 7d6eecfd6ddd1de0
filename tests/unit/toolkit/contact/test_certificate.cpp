// What the checker accepts and refuses, and that the cones contain each other as they must.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "contact/certificate.hpp"
#include "stances.hpp"

namespace foothold::contact {
namespace {

int stances() { return std::getenv("FOOTHOLD_LONG") != nullptr ? 1'000'000 : 20'000; }

bool accepted(const Verdict& verdict, const Stance& s, FrictionCone cone) { return proves(verdict, s.contacts, s.com, s.mu, cone); }

TEST(Certificate, OfEveryVerdictIsAcceptedForAnyCone) {
  for (const FrictionCone cone :
       {FrictionCone::circular(), FrictionCone::pyramid(3), FrictionCone::pyramid(4), FrictionCone::pyramid(64)}) {
    std::mt19937_64 random(7);
    Equilibrium equilibrium(cone);
    int refused = 0;
    for (int i = 0; i < stances() / 4; ++i) {
      const Stance s = random_stance(random);
      refused += accepted(equilibrium.judge(s.contacts, s.com, s.mu), s, cone) ? 0 : 1;
    }
    EXPECT_EQ(refused, 0) << cone.edges << " edges";
  }
}

TEST(Certificate, AConeHoldsWhatThePyramidInItHolds) {
  std::mt19937_64 random(8);
  Equilibrium exact(FrictionCone::circular()), fine(FrictionCone::pyramid(64)), coarse(FrictionCone::pyramid(10));
  int rejected = 0, more_than_fine = 0, more_than_coarse = 0;
  for (int i = 0; i < stances(); ++i) {
    const Stance s = random_stance(random);
    const Verdict& circular = exact.judge(s.contacts, s.com, s.mu);
    const Verdict& inscribed = fine.judge(s.contacts, s.com, s.mu);
    // What the pyramid's forces prove, they prove for the cone.
    if (inscribed.stable) {
      rejected += circular.stable ? 0 : 1;
      EXPECT_TRUE(accepted(inscribed, s, FrictionCone::circular()));
    }
    more_than_fine += circular.stable && !inscribed.stable ? 1 : 0;
    const Verdict& of_ten = coarse.judge(s.contacts, s.com, s.mu);
    rejected += of_ten.stable && !circular.stable ? 1 : 0;
    more_than_coarse += circular.stable && !of_ten.stable ? 1 : 0;
  }
  EXPECT_EQ(rejected, 0);
  EXPECT_GT(more_than_coarse, more_than_fine);
  EXPECT_GT(more_than_coarse, stances() / 1000);
}

TEST(Certificate, IsRefusedForAnotherStance) {
  std::mt19937_64 random(9);
  const FrictionCone cone = FrictionCone::pyramid(10);
  Equilibrium equilibrium(cone);
  for (int i = 0; i < 2000; ++i) {
    const Stance s = random_stance(random);
    const Verdict verdict = equilibrium.judge(s.contacts, s.com, s.mu);
    Stance other = s;
    other.com.x() += 1e-6;
    if (verdict.stable) {
      EXPECT_FALSE(accepted(verdict, other, cone));
    } else {
      other = s;
      other.contacts.push_back({s.com - Vector3d(0.0, 0.0, 0.1), Vector3d::UnitZ()});  // which alone holds the robot
      EXPECT_FALSE(accepted(verdict, other, cone));
    }
  }
}

TEST(Certificate, IsRefusedWhenItIsWrong) {
  std::mt19937_64 random(10);
  const FrictionCone cone = FrictionCone::circular();
  Equilibrium equilibrium(cone);
  int stable = 0;
  for (int i = 0; i < 2000; ++i) {
    const Stance s = random_stance(random);
    const Verdict verdict = equilibrium.judge(s.contacts, s.com, s.mu);
    ASSERT_TRUE(accepted(verdict, s, cone));
    stable += verdict.stable ? 1 : 0;
    Verdict wrong = verdict;
    wrong.stable = !verdict.stable;
    EXPECT_FALSE(accepted(wrong, s, cone));
    wrong = verdict;
    wrong.proved = false;
    EXPECT_FALSE(accepted(wrong, s, cone));
    wrong = verdict;
    if (verdict.stable) {
      wrong.forces[0].z() += 1e-8;  // out of balance
      EXPECT_FALSE(accepted(wrong, s, cone));
      wrong = verdict;
      wrong.forces.pop_back();
      EXPECT_FALSE(accepted(wrong, s, cone));
    } else {
      wrong.separating = -verdict.separating;
      EXPECT_FALSE(accepted(wrong, s, cone));
      wrong.separating = Vector6d::Unit(2);  // which every foot's own push exceeds
      EXPECT_FALSE(accepted(wrong, s, cone));
      wrong.separating.setZero();
      EXPECT_FALSE(accepted(wrong, s, cone));
      wrong.separating.setConstant(std::numeric_limits<double>::quiet_NaN());
      EXPECT_FALSE(accepted(wrong, s, cone));
    }
  }
  EXPECT_GT(stable, 200);
  EXPECT_LT(stable, 1800);
}

// Forces that balance but that no friction of this size gives.
TEST(Certificate, IsRefusedOutsideTheCone) {
  Verdict verdict{.stable = true, .proved = true, .forces = {{0.5, 0.0, 0.5}, {-0.5, 0.0, 0.5}}};
  const std::vector<Contact> contacts = {{{-0.2, 0.0, -0.2}, Vector3d::UnitZ()}, {{0.2, 0.0, -0.2}, Vector3d::UnitZ()}};
  EXPECT_TRUE(proves(verdict, contacts, Vector3d::Zero(), 1.0, FrictionCone::circular()));
  EXPECT_FALSE(proves(verdict, contacts, Vector3d::Zero(), 0.999, FrictionCone::circular()));
  EXPECT_FALSE(proves(verdict, contacts, Vector3d::Zero(), 1.0, FrictionCone::pyramid(5)));
  EXPECT_TRUE(proves(verdict, contacts, Vector3d::Zero(), 1.0, FrictionCone::pyramid(4)));
}

}  // namespace
}  // namespace foothold::contact
