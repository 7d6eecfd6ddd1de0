// Steps that stand, and each way to be wrong: refused, with its reason.
#include <functional>

#include "octopod/check/check.hpp"
#include "planning.hpp"

namespace foothold::octopod {
namespace {

// A step of a planned route up the paper's ramps, and what comes before it.
struct Walk {
  std::shared_ptr<const PreparedScene> scene;
  Step step;
  Posture before;
  CheckOptions options;

  const terrain::Surface& surface() const { return dynamic_cast<const Ground&>(*scene).surface(); }
  StepVerdict judge() const { return check_step(octopod(), surface(), step, before, options); }
};

constexpr std::size_t kJudged = 2;  // of the route's steps

Walk walk() {
  static const Walk planned = [] {
    const Parameters values = parameters();
    Walk out{shared_planner().prepare(shipped("terrain-ramps"), values), {}, {}, {}};
    Collector steps;
    const Request request = request_between(kPaperStart, kPaperB);
    shared_planner().plan(request, values, *out.scene, steps);
    out.step = steps.steps.at(kJudged);
    out.before = steps.steps.at(kJudged - 1).after;
    out.options.transitions = false;
    return out;
  }();
  return planned;
}

TEST(Steps, ThatStandAreAcceptedWithTheirMargins) {
  const StepVerdict verdict = walk().judge();
  ASSERT_TRUE(verdict.accepted) << verdict.reason;
  ASSERT_EQ(verdict.margins.size(), 4u);
  EXPECT_EQ(verdict.margins[0].name, "friction left");
  for (const Margin& margin : verdict.margins) EXPECT_GE(margin.value, margin.least) << margin.name;
}

struct Wrong {
  const char* name;
  const char* reason;  // a part of it
  std::function<void(Walk&)> spoil;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongSteps : public testing::TestWithParam<Wrong> {};

TEST_P(WrongSteps, AreRefusedWithTheReason) {
  Walk wrong = walk();
  GetParam().spoil(wrong);
  const StepVerdict verdict = wrong.judge();
  EXPECT_FALSE(verdict.accepted);
  EXPECT_NE(verdict.reason.find(GetParam().reason), std::string::npos) << verdict.reason;
  EXPECT_TRUE(verdict.margins.empty());
}

// Moves a contact wherever it is told, so that the step does not contradict itself.
void move_contact(Walk& walk, std::size_t k, const std::function<void(Isometry3d&)>& by) {
  for (Contact& contact : walk.step.after.stance)
    if (contact.limb == limb(static_cast<int>(k))) by(contact.frame);
  for (Contact& contact : walk.step.placed)
    if (contact.limb == limb(static_cast<int>(k))) by(contact.frame);
}

void lift_robot(Walk& walk, double by) { walk.step.after.base.translation().z() += by; }

INSTANTIATE_TEST_SUITE_P(
    EachWay, WrongSteps,
    testing::Values(Wrong{"JointsMissing", "gives 26 joints, not 27", [](Walk& w) { w.step.after.joints.pop_back(); }},
                    Wrong{"FootMissing", "7 feet are placed, not 8", [](Walk& w) { w.step.placed.pop_back(); }},
                    Wrong{"StanceOfSeven", "foot B4 does not stand", [](Walk& w) { w.step.after.stance.pop_back(); }},
                    Wrong{"FootTwice", "does not stand",
                          [](Walk& w) {
                            w.step.after.stance[7].limb = "A1";
                            w.step.placed[7].limb = "A1";
                          }},
                    Wrong{"PlacedElsewhere", "foot A2 does not stand where it is placed",
                          [](Walk& w) { w.step.placed[1].frame.translation().x() += 1e-6; }},
                    Wrong{"FootInTheAir", "foot A1 stands 1e-05 m from the ground",
                          [](Walk& w) { move_contact(w, 0, [](Isometry3d& f) { f.translation() += 1e-5 * f.linear().col(2); }); }},
                    Wrong{"FootUnderTheGround", "foot B2 stands 1e-05 m from the ground",
                          [](Walk& w) { move_contact(w, 5, [](Isometry3d& f) { f.translation() -= 1e-5 * f.linear().col(2); }); }},
                    Wrong{"NormalAstray", "the normal of foot A3's contact",
                          [](Walk& w) {
                            move_contact(w, 2, [](Isometry3d& f) {
                              f.linear() = (f.linear() * Eigen::AngleAxisd(1e-4, Vector3d::UnitX())).eval();
                            });
                          }},
                    Wrong{"FootBesideItsContact", "the joints put foot A4",
                          [](Walk& w) { move_contact(w, 3, [](Isometry3d& f) { f.translation() += 1e-5 * f.linear().col(0); }); }},
                    Wrong{"OneJointAstray", "the joints put foot B1", [](Walk& w) { w.step.after.joints[14] += 1e-4; }},
                    Wrong{"BallJointAstray", "the joints put foot B", [](Walk& w) { w.step.after.joints[26] += 1e-4; }},
                    Wrong{"RobotLifted", "the joints put foot", [](Walk& w) { lift_robot(w, 1e-5); }},
                    Wrong{"GroundTooSlippery", "is not in equilibrium at friction 0.001",
                          [](Walk& w) { w.options.friction = 0.001; }},
                    Wrong{"ClearanceNotKept", "m must be kept", [](Walk& w) { w.options.clearance = 0.05; }},
                    Wrong{"NoMotion", "brings no motion", [](Walk& w) { w.options.transitions = true; }},
                    Wrong{"BeforeStandsNowhere", "the posture before: 0 feet stand", [](Walk& w) { w.before.stance.clear(); }}),
    [](const auto& tested) { return std::string(tested.param.name); });

// Kneeling until a body or a leg meets the ground: feet stay, so that only the bodies are wrong.
TEST(Steps, WhoseBodiesCutTheGroundAreRefused) {
  Walk low = walk();
  Coordinates at = from_posture(low.step.after);
  int cut = 0;
  for (double down = 0.005; down < 0.12; down += 0.005) {
    Coordinates lowered = at;
    lowered.front.translation() -= down * at.front.linear().col(2);
    bool reached = true;
    for (int k = 0; k < kLegs && reached; ++k) {
      const Isometry3d module = modules(octopod(), lowered)[static_cast<std::size_t>(module_of(k))];
      const Contact& contact = low.step.after.stance[static_cast<std::size_t>(k)];
      const auto joints = natural_leg(octopod(), k, module.inverse() * contact.frame.translation());
      reached = joints.has_value();
      if (reached) lowered.legs[static_cast<std::size_t>(k)] = *joints;
    }
    if (!reached) break;
    Walk lower = low;
    const std::vector<Contact> stance = lower.step.after.stance;
    lower.step.after = to_posture(lowered);
    lower.step.after.stance = stance;
    const StepVerdict verdict = lower.judge();
    if (!verdict.accepted) {
      EXPECT_NE(verdict.reason.find("cuts the ground"), std::string::npos) << verdict.reason;
      ++cut;
    }
  }
  EXPECT_GT(cut, 1);
}

// The other knee: all feet stand, but legs come through the ground from below.
TEST(Steps, WhoseLegsBendTheWrongWayAreRefused) {
  Walk bent = walk();
  Coordinates at = from_posture(bent.step.after);
  const std::vector<Contact> stance = bent.step.after.stance;
  int refused = 0;
  for (int k = 0; k < kLegs; ++k) {
    const Isometry3d module = modules(octopod(), at)[static_cast<std::size_t>(module_of(k))];
    const LegSolutions all = inverse_leg(octopod(), k, module.inverse() * stance[static_cast<std::size_t>(k)].frame.translation());
    for (int i = 0; i < all.count; ++i) {
      Coordinates other = at;
      other.legs[static_cast<std::size_t>(k)] = all.joints[static_cast<std::size_t>(i)];
      Walk now = bent;
      now.step.after = to_posture(other);
      now.step.after.stance = stance;
      if (!now.judge().accepted) ++refused;
    }
  }
  EXPECT_GE(refused, 4);
}

TEST(Steps, WithoutStabilitySayWhatTheyLack) {
  Walk walk_of = walk();
  walk_of.options.stability = false;
  walk_of.options.friction = 0.001;
  const StepVerdict verdict = walk_of.judge();
  ASSERT_TRUE(verdict.accepted) << verdict.reason;
  EXPECT_EQ(verdict.margins[0].name, "friction left, not demanded");
  EXPECT_LT(verdict.margins[0].value, 0.0);
}

}  // namespace
}  // namespace foothold::octopod
