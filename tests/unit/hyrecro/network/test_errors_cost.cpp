// What the network's errors cost the planner of the paper: footholds that nothing reaches, and routes that are not found. check()
// must refuse every foothold that is not reached, and no other.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fixtures.hpp"
#include "hyrecro/check/check.hpp"
#include "hyrecro/paper/paper.hpp"
#include "hyrecro/scene/random_foothold.hpp"
#include "hyrecro/steps.hpp"
#include "truss/generate.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kClearance = 0.005;  // m

// The worst network: all that the legs' length does not forbid is reachable.
class SaysYes final : public Reachability {
 public:
  explicit SaysYes(double radius) : radius_(radius) {}
  Reach reach(const Isometry3d& pose, const Admit&) override { return {pose.translation().norm() < radius_, std::nullopt}; }

 private:
  double radius_;
};

// Steps of plans, by what forward kinematics and what check() say of them.
struct Tally {
  int plans = 0, plans_with_a_wrong_foothold = 0, steps = 0, wrong = 0, wrong_refused = 0, right_refused = 0;
  std::string first_right_refused;
};

double missed_by(const Model& m, const Coordinates& coordinates, const Isometry3d& free_in_holding) {
  return (forward(m, coordinates).matrix() - free_in_holding.matrix()).cwiseAbs().maxCoeff();
}

void count(const Model& m, const PreparedTruss& scene, const Route& route, Tally& tally) {
  Grip holding{Foot::kA, route.start};
  Posture before;
  before.stance = {to_contact(scene.truss, holding)};
  const int wrong_before = tally.wrong;
  for (const Stride& stride : route.strides) {
    const Step step = to_step(m, scene.truss, holding, stride, 1.0);
    if (before.joints.empty()) {
      before.joints = step.after.joints;
      before.base = step.after.base;
    }
    CheckOptions options;
    options.clearance = kClearance;
    const StepVerdict verdict = check_step(m, scene.truss, scene.obstacles, options, step, before);
    const Isometry3d pose = pose_of(scene.truss, holding.at).inverse() * pose_of(scene.truss, stride.to);
    const bool wrong = missed_by(m, stride.coordinates, pose) > 1e-6;
    ++tally.steps;
    tally.wrong += wrong;
    tally.wrong_refused += wrong && !verdict.accepted;
    tally.right_refused += !wrong && !verdict.accepted;
    if (!wrong && !verdict.accepted && tally.first_right_refused.empty()) tally.first_right_refused = verdict.reason;
    before = step.after;
    holding = {other(holding.foot), stride.to};
  }
  ++tally.plans;
  tally.plans_with_a_wrong_foothold += tally.wrong > wrong_before;
}

TEST(NetworkErrors, OfEitherKindAreCountedAndEveryWrongFootholdIsRefused) {
  const Model m = model();
  const auto workspace =
      std::make_shared<const PlanarWorkspace>(*PlanarWorkspace::make(m, 0.01, std::numbers::pi / 36.0, kClearance));
  const auto exact = make_exact(m, kClearance), network = make_network(m);
  SaysYes says_yes(farthest(PoseKind::kTransition, m));
  Tally of_exact, of_network, of_yes;
  int missed = 0, only_network = 0, longer = 0, both = 0;
  const int scenes = long_run() ? 60 : 5;
  for (int s = 0; s < scenes; ++s) {
    const auto family = static_cast<truss::Family>(s % 3);
    const auto seed = static_cast<std::uint64_t>(1000 + s);
    PreparedTruss scene(m, truss::build(truss::generate(family, seed, 3 + s % 5)), SamplingOptions{}, kClearance);
    scene.workspace = workspace;
    std::mt19937_64 random(seed);
    for (int pair = 0; pair < 3; ++pair) {
      const auto start = random_foothold(m, scene.truss, random), goal = random_foothold(m, scene.truss, random);
      ASSERT_TRUE(start && goal);
      const auto plan = [&](Reachability& method, Tally& tally) {
        Found found = plan_paper(m, scene, method, *start, *goal, PaperOptions{}, {}, {});
        if (found.outcome == Found::Outcome::kReached) count(m, scene, found.route, tally);
        return found;
      };
      const Found by_exact = plan(*exact, of_exact), by_network = plan(*network, of_network);
      plan(says_yes, of_yes);
      const bool a = by_exact.outcome == Found::Outcome::kReached, b = by_network.outcome == Found::Outcome::kReached;
      both += a && b;
      missed += a && !b;
      only_network += !a && b;
      longer += a && b && by_network.cost > by_exact.cost;
    }
  }
  const auto say = [](const char* name, const Tally& t) {
    std::printf(
        "%-8s %d plans, %d with a wrong foothold; %d steps, %d wrong, of which check() refused %d; right ones refused %d %s\n",
        name, t.plans, t.plans_with_a_wrong_foothold, t.steps, t.wrong, t.wrong_refused, t.right_refused,
        t.first_right_refused.c_str());
  };
  say("exact", of_exact);
  say("network", of_network);
  say("yes", of_yes);
  std::printf("found by both %d, missed by the network %d, by the network alone %d, longer by it %d\n", both, missed, only_network,
              longer);

  EXPECT_EQ(of_exact.wrong, 0);
  for (const Tally* tally : {&of_exact, &of_network, &of_yes}) {
    EXPECT_EQ(tally->wrong_refused, tally->wrong);
    EXPECT_EQ(tally->right_refused, 0) << tally->first_right_refused;
  }
  EXPECT_GT(of_yes.wrong, 0) << "no wrong foothold to refuse";
  EXPECT_GT(both, scenes);
  EXPECT_LE(missed, 1 + (both + missed) / 20);
}

}  // namespace
}  // namespace foothold::hyrecro
