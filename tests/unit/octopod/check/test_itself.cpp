// Robots that touch themselves before the judge: in a stance and on the way; and the judge's distances against the toolkit's.
#include <gtest/gtest.h>

#include "collision/distance.hpp"
#include "grounds.hpp"
#include "octopod/check/check.hpp"
#include "octopod/check/itself.hpp"
#include "octopod/posture/pair.hpp"

namespace foothold::octopod {
namespace {

using Points = std::array<Vector3d, kLegs>;

const TestGround& level() {
  static const auto ground = level_ground();
  return *ground;
}

// On level ground, C above the origin, the axis along X.
Pair bodies() { return {{0, 0, octopod().height}, {Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()}}; }
Points usual() {
  Points out;
  for (int k = 0; k < kLegs; ++k) {
    const Vector3d at = shoulder(octopod(), bodies(), k);
    out[static_cast<std::size_t>(k)] = {at.x(), at.y() + 0.1 * side(k), 0.0};
  }
  return out;
}

Posture posture_of(const Points& feet) {
  const auto at = reaching(octopod(), bodies(), feet);
  EXPECT_TRUE(at);
  Posture out = to_posture(*at);
  for (int k = 0; k < kLegs; ++k) {
    Contact contact;
    contact.limb = limb(k);
    contact.frame.translation() = feet[static_cast<std::size_t>(k)];
    out.stance.push_back(contact);
  }
  return out;
}

StepVerdict judge(const Posture& before, const Step& step, double clearance = 0.0) {
  CheckOptions options;
  options.transitions = !step.motion.empty();
  options.clearance = clearance;
  return check_step(octopod(), level().surface, step, before, options);
}

StepVerdict judge_stance(const Points& feet, double clearance = 0.0) {
  Step step;
  step.after = posture_of(feet);
  step.placed = step.after.stance;
  return judge(posture_of(usual()), step, clearance);
}

void expect_names(const StepVerdict& verdict, const std::string& a, const std::string& b) {
  EXPECT_FALSE(verdict.accepted);
  EXPECT_NE(verdict.reason.find(a), std::string::npos) << verdict.reason;
  EXPECT_NE(verdict.reason.find(b), std::string::npos) << verdict.reason;
}

TEST(Itself, AStanceWithLegsApartIsAcceptedAndSaysHowFar) {
  const StepVerdict verdict = judge_stance(usual());
  ASSERT_TRUE(verdict.accepted) << verdict.reason;
  const auto apart = std::find_if(verdict.margins.begin(), verdict.margins.end(),
                                  [](const Margin& margin) { return margin.name == "legs and bodies apart"; });
  ASSERT_NE(apart, verdict.margins.end());
  EXPECT_NEAR(apart->value, octopod().neck - octopod().neck_radius, 1e-12) << "a neck ends so far from the other body";
}

TEST(Itself, CrossedLegsAreRefusedByName) {
  // A4's foot and B2's change places.
  Points feet = usual();
  std::swap(feet[3], feet[5]);
  expect_names(judge_stance(feet), "A4 ", "B2 ");
  // A1 and A3 likewise, as far as they reach: past each other by a centimetre, half way.
  feet = usual();
  const double middle = (feet[0].x() + feet[2].x()) / 2;
  feet[0].x() = middle - 0.005, feet[2].x() = middle + 0.005;
  expect_names(judge_stance(feet), "A1 ", "A3 ");
}

TEST(Itself, FeetBesideEachOtherKeepTheClearance) {
  Points feet = usual();
  const double middle = (feet[2].x() + feet[4].x()) / 2;
  feet[2].x() = middle + 0.015, feet[4].x() = middle - 0.015;
  EXPECT_TRUE(judge_stance(feet).accepted) << judge_stance(feet).reason;
  expect_names(judge_stance(feet, 0.012), "A3 tibia", "B1 tibia");
}

// A1 goes back, up, along and down: `by` (m) and home again, while A3 stands 12 cm behind A1's shoulder.
StepVerdict judge_way(double by) {
  Points feet = usual();
  feet[2].x() = feet[0].x() - 0.12;
  const Posture before = posture_of(feet);
  Step step;
  step.after = before;
  step.placed = before.stance;
  const Vector3d home = feet[0], up = home + Vector3d(0, 0, 0.03), far = up - Vector3d(by, 0, 0);
  double time = 0.0;
  const auto go = [&](const Vector3d& from, const Vector3d& to) {
    for (int k = 1; k <= 20; ++k) {
      feet[0] = from + k / 20.0 * (to - from);
      const Posture at = posture_of(feet);
      step.motion.push_back({time += 0.5, at.base, at.joints});
    }
  };
  step.motion.push_back({0.0, before.base, before.joints});
  go(home, up);
  go(up, far);
  go(far, up);
  go(up, home);
  return judge(before, step);
}

TEST(Itself, AMotionThatSweepsThroughALegIsRefusedAndOneThatStopsShortIsNot) {
  EXPECT_TRUE(judge_way(0.07).accepted) << judge_way(0.07).reason;
  expect_names(judge_way(0.13), "A1 tibia", "A3 tibia");
}

TEST(Itself, AMotionWhosePointsAreApartButNotWhatIsBetweenIsRefused) {
  // Straight through A3 between two points 4 cm before and behind it.
  Points feet = usual();
  feet[2].x() = feet[0].x() - 0.09;
  const Posture before = posture_of(feet);
  Step step;
  step.after = before;
  step.placed = before.stance;
  const Vector3d home = feet[0], up = home + Vector3d(0, 0, 0.03);
  double time = 0.0;
  const auto point = [&](const Vector3d& foot) {
    feet[0] = foot;
    const Posture at = posture_of(feet);
    step.motion.push_back({time, at.base, at.joints});
    time += 1.0;
  };
  for (int k = 0; k <= 20; ++k) point(home + k / 20.0 * (up - home));
  point(up - Vector3d(0.05, 0, 0));
  point(up - Vector3d(0.13, 0, 0));
  point(up);
  for (int k = 20; k >= 0; --k) point(home + k / 20.0 * (up - home));
  expect_names(judge(before, step), "A1 ", "A3 ");
}

TEST(Itself, DistancesAreTheToolkits) {
  std::mt19937_64 random(5);
  int met = 0, apart = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto box = [&] {
      collision::Box out{Isometry3d::Identity(), random_vector(random, 0.3).cwiseAbs() + Vector3d::Constant(0.01)};
      out.pose.linear() = random_rotation(random).toRotationMatrix();
      out.pose.translation() = random_vector(random, 0.5);
      return out;
    };
    const collision::Box a = box(), b = box();
    const Vector3d p = random_vector(random, 0.6), q = random_vector(random, 0.6), r = random_vector(random, 0.6),
                   s = random_vector(random, 0.6);
    EXPECT_NEAR(distance(p, q, r, s), collision::distance(collision::Capsule{p, q, 0.0}, collision::Capsule{r, s, 0.0}), 1e-9);
    EXPECT_NEAR(distance(a.pose, a.half, p, q), collision::distance(collision::Capsule{p, q, 0.0}, a), 1e-9);
    const double boxes = collision::distance(a, b);
    EXPECT_NEAR(distance(a.pose, a.half, b.pose, b.half), boxes, 1e-9);
    ++(boxes > 0.0 ? apart : met);
  }
  EXPECT_GT(met, 200);
  EXPECT_GT(apart, 200);
}

}  // namespace
}  // namespace foothold::octopod
