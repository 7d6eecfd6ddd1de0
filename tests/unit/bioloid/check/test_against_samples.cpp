// The proof against a dense look at random lines in single support, with the model's own kinematics: what the look finds at fault
// is refused, what it finds sound by more than it can overlook is accepted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "collision/distance.hpp"
#include "steps.hpp"

namespace foothold::bioloid {
namespace {

using testing::kDegree;
using testing::shipped_model;

constexpr std::size_t kRightFoot = leg_joint(Side::kRight, 5) + 1, kLeftFoot = leg_joint(Side::kLeft, 5) + 1;

struct Least {
  double clearance = HUGE_VAL, balance = HUGE_VAL, ground = HUGE_VAL, bodies = HUGE_VAL;
};

double over_ground(const collision::Box& box) {
  double least = HUGE_VAL;
  for (int i = 0; i < 8; ++i)
    least = std::min(least,
                     (box.pose * box.half.cwiseProduct(Vector3d(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0))).z());
  return least;
}

// The right sole stands in the origin. `brick` is an obstacle's box.
void look(const Joints& joints, const collision::Box& brick, Least& least) {
  const Model& model = shipped_model();
  const Isometry3d torso = sole_in_torso(model, Side::kRight, joints).inverse();
  const auto frames = body_frames(model, joints);
  const Vector3d centre = torso * centre_of_mass(model, joints);
  least.balance = std::min({least.balance, 0.05 - std::abs(centre.x()), 0.03 - std::abs(centre.y())});
  std::vector<std::pair<std::size_t, collision::Box>> boxes;
  for (std::size_t body = 0; body < kBodies; ++body)
    for (const BodyBox& box : model.bodies[body].boxes)
      boxes.push_back({body, {torso * frames[body] * Eigen::Translation3d(box.centre), box.half}});
  for (const auto& [body, box] : boxes) {
    least.clearance = std::min(least.clearance, collision::distance(box, brick));
    if (body == kLeftFoot)
      least.ground = std::min(least.ground, over_ground(box));
    else if (body != kRightFoot)
      least.bodies = std::min(least.bodies, over_ground(box));
    for (const auto& [other, second] : boxes)
      if (other > body && !model.neighbours(body, other))
        least.clearance = std::min(least.clearance, collision::distance(box, second));
  }
}

TEST(BioloidCheckAgainstSamples, RandomLinesInSingleSupport) {
  const Model& model = shipped_model();
  const Isometry3d ground = Isometry3d::Identity();
  const Coordinates middle =
      testing::standing_with(model, ground, Isometry3d(Eigen::Translation3d(0.01, 0.08, 0.015)), {0, 0}, 0.185, 0.0);
  const Prism prism{"brick", {{0.07, 0.05}, {0.11, 0.05}, {0.11, 0.09}, {0.07, 0.09}}, 0.01};
  const collision::Box brick{Isometry3d(Eigen::Translation3d(0.09, 0.07, -0.495)), {0.02, 0.02, 0.505}};
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> unit(-1.0, 1.0), sizes(0.3, 1.0);
  int sound = 0, faulty = 0;
  for (int i = 0; i < 400; ++i) {
    const double size = 9 * kDegree * sizes(random);
    const auto about_middle = [&] {
      Joints joints = middle.joints;
      for (int j = 0; j < joints.size(); ++j) joints[j] += (j < 6 ? 5.0 : 1.0) * size * unit(random);
      return joints;
    };
    const Joints a = about_middle(), b = about_middle();
    if (!within_limits(model, a) || !within_limits(model, b)) continue;
    const auto posture_of = [&](const Joints& joints) {
      Posture out = to_posture({sole_in_torso(model, Side::kRight, joints).inverse(), joints});
      out.stance = {{"right_foot", ground, ""}};
      return out;
    };
    Step step;
    const Posture before = posture_of(a);
    step.after = posture_of(b);
    step.motion = {{0.0, before.base, before.joints}, {10.0, step.after.base, step.after.joints}};
    constexpr int kSamples = 120;
    Least least;
    for (int k = 0; k <= kSamples; ++k) look(a + (b - a) * k / kSamples, brick, least);
    const CheckOptions options{.clearance = 0.002, .balance = 0.005, .ground = 2e-4};
    const double worst = std::min(
        {least.clearance - options.clearance, least.balance - options.balance, least.ground + options.ground, least.bodies});
    const StepVerdict verdict = check_step(model, std::vector<Prism>{prism}, step, before, options);
    if (worst < -2e-5) {
      EXPECT_FALSE(verdict.accepted) << worst;
      ++faulty;
    } else if (worst > 5e-4) {
      EXPECT_TRUE(verdict.accepted) << worst << ": " << verdict.reason;
      ++sound;
      for (const Margin& margin : verdict.margins) {
        if (margin.name == "balance") {
          EXPECT_NEAR(margin.value, least.balance, 2e-3);
        }
        if (margin.name == "clearance") {
          EXPECT_NEAR(margin.value, std::min(0.1, least.clearance), 2e-3);
        }
      }
    }
  }
  EXPECT_GT(sound, 30);
  EXPECT_GT(faulty, 30);
  RecordProperty("sound", sound);
  RecordProperty("faulty", faulty);
}

}  // namespace
}  // namespace foothold::bioloid
