// What the search's judge certifies the check accepts: two proofs that share neither code nor method agree on random motions.
#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <stdexcept>

#include "bioloid/posture/judge.hpp"
#include "steps.hpp"

namespace foothold::bioloid {
namespace {

using testing::kDegree;
using testing::shipped_model;

struct Tally {
  int certified = 0, both_refuse = 0, only_check_accepts = 0;

  // What the search certifies the check has to accept.
  void count(bool by_search, const StepVerdict& by_check) {
    if (by_search) {
      EXPECT_TRUE(by_check.accepted) << by_check.reason;
      ++certified;
    } else {
      ++(by_check.accepted ? only_check_accepts : both_refuse);
    }
  }
};

std::optional<Coordinates> standing_on(const Isometry3d& left, const Eigen::Vector2d& centre) {
  try {
    return testing::standing_with(shipped_model(), Isometry3d::Identity(), left, centre, 0.187, 0.0);
  } catch (const std::runtime_error&) {
    return {};  // out of reach
  }
}

// A motion of one line, before and after which the same soles stand.
StepVerdict checked(const Joints& a, const Joints& b, const std::vector<Contact>& stance, const Isometry3d& torso_a,
                    const Isometry3d& torso_b, const std::vector<Prism>& prisms) {
  Posture before = to_posture({torso_a, a});
  before.stance = stance;
  Step step;
  step.after = to_posture({torso_b, b});
  step.after.stance = stance;
  step.motion = {{0.0, before.base, before.joints}, {10.0, step.after.base, step.after.joints}};
  return check_step(shipped_model(), prisms, step, before, {});
}

TEST(BioloidCheckAgainstSearch, SingleSupport) {
  const Model& model = shipped_model();
  const std::vector<Prism> prisms{{"brick", {{0.07, 0.05}, {0.11, 0.05}, {0.11, 0.09}, {0.07, 0.09}}, 0.01}};
  Judge judge(model, {}, prisms);
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Tally tally;
  for (int i = 0; i < 3000; ++i) {
    const Isometry3d swing(
        Eigen::Translation3d(0.02 + 0.03 * unit(random), 0.077 + 0.015 * unit(random), 0.012 + 0.01 * unit(random)));
    const auto about = standing_on(swing, {0.015 * unit(random), 0.008 * unit(random)});
    if (!about) continue;
    Joints a = about->joints, b = about->joints;
    for (int j = 6; j < a.size(); ++j) {
      a[j] += 2 * kDegree * unit(random);
      b[j] += 2 * kDegree * unit(random);
    }
    const Isometry3d torso_a = sole_in_torso(model, Side::kRight, a).inverse(),
                     torso_b = sole_in_torso(model, Side::kRight, b).inverse();
    const bool certified = judge.motion(a, b, Support{}) == Fault::kNone;
    const StepVerdict verdict = checked(a, b, {{"right_foot", Isometry3d::Identity(), ""}}, torso_a, torso_b, prisms);
    tally.count(certified, verdict);
  }
  RecordProperty("certified", tally.certified);
  RecordProperty("both_refuse", tally.both_refuse);
  RecordProperty("only_check_accepts", tally.only_check_accepts);
  EXPECT_GT(tally.certified, 300);
  EXPECT_GT(tally.both_refuse, 300);
  // The search may give up near its demands, not far from them.
  EXPECT_LT(tally.only_check_accepts, 100);
}

TEST(BioloidCheckAgainstSearch, DoubleSupport) {
  const Model& model = shipped_model();
  Judge judge(model, {});
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Tally tally;
  for (int i = 0; i < 2000; ++i) {
    Isometry3d second(Eigen::Translation3d(0.05 * unit(random), 0.08 + 0.01 * unit(random), 0.0));
    second.rotate(Eigen::AngleAxisd(0.1 * unit(random), Vector3d::UnitZ()));
    const Eigen::Vector2d centre = 0.5 * second.translation().head<2>() + Eigen::Vector2d(0.02 * unit(random), 0.05 * unit(random));
    const double far = 0.02 * (1.0 + unit(random));
    const auto from = standing_on(second, centre);
    const auto to = standing_on(second, centre + far * Eigen::Vector2d(unit(random), unit(random)));
    if (!from || !to) continue;
    const Joints &a = from->joints, &b = to->joints;
    if (!within_limits(model, a) || !within_limits(model, b)) continue;
    const Support support{Side::kRight, Isometry3d::Identity(), true, second};
    const bool certified = judge.motion(a, b, support) == Fault::kNone;
    const StepVerdict verdict =
        checked(a, b, {{"right_foot", Isometry3d::Identity(), ""}, {"left_foot", second, ""}}, from->pelvis, to->pelvis, {});
    tally.count(certified, verdict);
  }
  RecordProperty("certified", tally.certified);
  RecordProperty("both_refuse", tally.both_refuse);
  RecordProperty("only_check_accepts", tally.only_check_accepts);
  EXPECT_GT(tally.certified, 300);
  EXPECT_GT(tally.both_refuse, 100);
  EXPECT_LT(tally.only_check_accepts, 100);
}

}  // namespace
}  // namespace foothold::bioloid
