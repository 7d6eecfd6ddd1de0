// The second judge: an independent method must say the same, with proofs of its own.
#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

#include "contact/certificate.hpp"
#include "contact/projection.hpp"
#include "stances.hpp"

namespace foothold::contact {
namespace {

int stances() { return std::getenv("FOOTHOLD_LONG") != nullptr ? 500'000 : 10'000; }

TEST(Projection, AgreesWithTheSimplexMethodAndProvesItsVerdicts) {
  for (const FrictionCone cone : {FrictionCone::circular(), FrictionCone::pyramid(3), FrictionCone::pyramid(10)}) {
    std::mt19937_64 random(11);
    Equilibrium equilibrium(cone);
    int differ = 0, refused = 0;
    for (int i = 0; i < stances(); ++i) {
      const Stance s = random_stance(random);
      const Verdict verdict = judge_by_projection(s.contacts, s.com, s.mu, cone);
      differ += verdict.stable == equilibrium.judge(s.contacts, s.com, s.mu).stable ? 0 : 1;
      refused += proves(verdict, s.contacts, s.com, s.mu, cone) ? 0 : 1;
    }
    EXPECT_EQ(differ, 0) << cone.edges << " edges";
    EXPECT_EQ(refused, 0) << cone.edges << " edges";
  }
}

TEST(Projection, JudgesWhatHasNoFrictionOrNoContacts) {
  const std::vector<Contact> three = {
      {{0.2, 0.0, 0.0}, Vector3d::UnitZ()}, {{-0.1, 0.1, 0.0}, Vector3d::UnitZ()}, {{-0.1, -0.1, 0.0}, Vector3d::UnitZ()}};
  for (const FrictionCone cone : {FrictionCone::circular(), FrictionCone::pyramid(10)}) {
    const auto stable = [&](std::span<const Contact> contacts, const Vector3d& com) {
      const Verdict verdict = judge_by_projection(contacts, com, 0.0, cone);
      EXPECT_TRUE(proves(verdict, contacts, com, 0.0, cone));
      return verdict.stable;
    };
    EXPECT_TRUE(stable(three, {0.0, 0.0, 0.2}));
    EXPECT_FALSE(stable(three, {-0.11, 0.0, 0.2}));
    EXPECT_FALSE(stable({}, {0.0, 0.0, 0.2}));
  }
}

TEST(Projection, RefusesWhatIsNoStance) {
  const std::vector<Contact> bad = {{Vector3d::Zero(), Vector3d(0.0, 0.0, 2.0)}};
  EXPECT_THROW(judge_by_projection(bad, Vector3d::UnitZ(), 0.5, FrictionCone::circular()), std::invalid_argument);
  EXPECT_THROW(judge_by_projection({}, Vector3d::UnitZ(), -0.5, FrictionCone::circular()), std::invalid_argument);
  EXPECT_THROW(judge_by_projection({}, Vector3d::UnitZ(), 0.5, FrictionCone::pyramid(1)), std::invalid_argument);
}

}  // namespace
}  // namespace foothold::contact
