// Sound steps are accepted; each way to be wrong is refused with its reason.
#include <functional>
#include <random>

#include "hexpiderix/steps.hpp"
#include "hexpiderix/walk/instant.hpp"
#include "steps.hpp"

namespace foothold::hexpiderix::testing {
namespace {

TEST(SoundSteps, AreAcceptedWithTheirMargins) {
  std::vector<Judged> all = walked();
  ASSERT_GT(all.size(), 4U);
  all.push_back(adapted());
  all.push_back(joined());
  for (const Judged& sound : all) {
    const StepVerdict verdict = verdict_of(sound);
    ASSERT_TRUE(verdict.accepted) << sound.step.label << ": " << verdict.reason;
    EXPECT_EQ(verdict.margins.size(), 4U);
    for (const Margin& margin : verdict.margins) EXPECT_GE(margin.value, margin.least) << margin.name;
  }
}

struct Wrong {
  const char* name;
  const char* reason;  // a part of it
  std::function<void(Judged&)> spoil;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

void expect_refused(const Judged& wrong, const std::string& reason) {
  const StepVerdict verdict = verdict_of(wrong);
  EXPECT_FALSE(verdict.accepted);
  EXPECT_NE(verdict.reason.find(reason), std::string::npos) << verdict.reason;
  EXPECT_TRUE(verdict.margins.empty());
}

class WrongSteps : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongSteps, AreRefusedWithTheReason) {
  Judged wrong = adapted();
  GetParam().spoil(wrong);
  expect_refused(wrong, GetParam().reason);
}

void move_contact(Judged& judged, const std::string& limb, const std::function<void(Isometry3d&)>& by) {
  for (auto* contacts : {&judged.step.after.stance, &judged.step.placed})
    for (Contact& contact : *contacts)
      if (contact.limb == limb) by(contact.frame);
}

MotionPoint& middle(Judged& judged) { return judged.step.motion[judged.step.motion.size() / 2]; }

void slow_down(Judged& judged) {
  for (MotionPoint& point : judged.step.motion) point.time *= 1e4;
}

INSTANTIATE_TEST_SUITE_P(
    EachWay, WrongSteps,
    ::testing::Values(
        Wrong{"JointsMissing", "gives 17 joints, not 18", [](Judged& w) { w.step.after.joints.pop_back(); }},
        Wrong{"JointsMissingBefore", "gives 17 joints, not 18", [](Judged& w) { w.before.joints.pop_back(); }},
        Wrong{"FootInTheAir", "foot L1 is 1e-05 m off the ground",
              [](Judged& w) { move_contact(w, "L1", [](Isometry3d& f) { f.translation() += 1e-5 * f.linear().col(2); }); }},
        Wrong{"FootUnderTheGround", "foot L5 is 1e-05 m off the ground",
              [](Judged& w) { move_contact(w, "L5", [](Isometry3d& f) { f.translation() -= 1e-5 * f.linear().col(2); }); }},
        Wrong{
            "NormalAstray", "the contact of L3 is not along the ground's normal",
            [](Judged& w) { move_contact(w, "L3", [](Isometry3d& f) { f.rotate(Eigen::AngleAxisd(1e-4, Vector3d::UnitX())); }); }},
        Wrong{"NoLeg", "'L7' is no leg", [](Judged& w) { w.step.after.stance[0].limb = "L7"; }},
        Wrong{"StandsTwice", "L3 stands twice", [](Judged& w) { w.step.after.stance[0].limb = "L3"; }},
        Wrong{"TwoFeet", "only 2 feet stand", [](Judged& w) { w.step.after.stance.pop_back(); }},
        Wrong{"TwoFeetBefore", "the posture before: only 2 feet stand", [](Judged& w) { w.before.stance.pop_back(); }},
        Wrong{"PlacedElsewhere", "foot L1 does not stand where it is placed",
              [](Judged& w) { w.step.placed[0].frame.translation().x() += 1e-6; }},
        Wrong{"NotPlaced", "stands where it is not placed",
              [](Judged& w) {
                w.step.placed.clear();
                w.before.stance[0].frame.translate(Vector3d(1e-3, 0, 0));
              }},
        Wrong{"JointOffLimits", "L1.q1 is 0.8 rad, outside", [](Judged& w) { w.step.after.joints[0] = 0.8; }},
        Wrong{"JointOffLimitsOnTheWay", "a point of the motion: L2.q3 is 0.1 rad, outside",
              [](Judged& w) { middle(w).joints[5] = 0.1; }},
        Wrong{"OneJointAstray", "by its joints, a foot is", [](Judged& w) { w.step.after.joints[1] += 1e-4; }},
        Wrong{"RobotLifted", "by its joints, a foot is", [](Judged& w) { w.step.after.base.translation().z() += 1e-5; }},
        Wrong{"LegInTheGround", "leg L2 is 0 m from the terrain",
              [](Judged& w) {
                w.step.motion.clear();
                w.step.after.joints[4] = -1.5;
              }},
        Wrong{"FootUnderTheTerrainOnTheWay", "L6",
              [](Judged& w) {
                slow_down(w);
                middle(w).joints[16] = -1.0;
                middle(w).joints[17] = -0.5;
              }},
        Wrong{"ClearanceNotKept", "m are demanded", [](Judged& w) { w.options.clearance = 0.05; }},
        Wrong{"GroundTooSlippery", "the posture after is not in equilibrium at friction 0.2",
              [](Judged& w) { w.options.friction = 0.2; }},
        Wrong{"MotionBeginsElsewhere", "does not begin at the posture before",
              [](Judged& w) { w.step.motion.front().joints[0] += 1e-5; }},
        Wrong{"MotionBeginsLate", "the motion begins at 1 s",
              [](Judged& w) {
                for (MotionPoint& point : w.step.motion) point.time += 1.0;
              }},
        Wrong{"MotionEndsElsewhere", "does not end at the posture after", [](Judged& w) { w.step.motion.pop_back(); }},
        Wrong{"TimeRunsBack", "time runs back", [](Judged& w) { middle(w).time = 1e3; }},
        Wrong{"TooFast", "the motion turns a joint by",
              [](Judged& w) {
                for (MotionPoint& point : w.step.motion) point.time *= 0.9;
              }},
        Wrong{"FootStraysAtAPoint", "supporting foot L1 strays",
              [](Judged& w) {
                slow_down(w);
                middle(w).joints[1] += 1e-4;
              }},
        Wrong{"FootStraysBetweenPoints", "a supporting foot strays by",
              [](Judged& w) {
                w.step.motion.erase(w.step.motion.begin() + 1, w.step.motion.end() - 1);
                slow_down(w);
              }}),
    [](const auto& tested) { return std::string(tested.param.name); });

// Legs 1, 4 and 5 stand; legs 2 and 3 swing as they are told.
Judged with_swinging(const Vector3d& second, const Vector3d& third) {
  const Plane plane = tilted_plane(kSlope, 0.0);
  const Footholds feet = standing_footholds(shipped_model(), plane, Vector3d::Zero(), 0.0, Legs{0b011001});
  Coordinates at{standing_thorax(shipped_model(), plane, Vector3d::Zero(), 0.0), {}};
  at.legs.fill(standing_joints());
  at.legs[5] = swinging_joints(shipped_model(), 5, shipped_model().lift);
  at.legs[1] = second;
  at.legs[2] = third;
  Judged out;
  out.step.after = standing_posture(at, feet);
  out.step.placed = out.step.after.stance;
  out.before = out.step.after;
  return out;
}

TEST(SwingingLegs, ThatTouchWhatTheyMustNotAreRefused) {
  const Vector3d away(0.0, 1.0, -0.5);
  expect_refused(with_swinging({0.69, 0.3, -0.3}, {-0.69, 0.3, -0.3}), "legs L2 and L3 are 0 m apart");
  expect_refused(with_swinging({0.0, -1.5, -2.6}, away), "leg L2 touches the thorax");
  expect_refused(with_swinging(away, swinging_joints(shipped_model(), 2, -0.01)), "foot L3 swings under the terrain");
}

// The standing robot with its thorax elsewhere, feet where they are.
Judged with_thorax(const Isometry3d& thorax) {
  Judged out = adapted();
  out.step.motion.clear();
  Coordinates at = from_posture(out.before);
  std::array<Vector3d, kLegs> feet{};
  for (std::size_t leg = 0; leg < kLegs; ++leg) feet[leg] = at.thorax * leg_points(shipped_model(), leg, at.legs[leg]).foot;
  at.thorax = thorax;
  for (const Contact& contact : out.before.stance) {
    const auto leg = static_cast<std::size_t>(contact.limb[1] - '1');
    const auto joints = reach(shipped_model(), leg, thorax.inverse() * feet[leg]);
    EXPECT_TRUE(joints) << contact.limb;
    if (joints) at.legs[leg] = *joints;
  }
  const std::vector<Contact> stance = out.before.stance;
  out.step.after = to_posture(at);
  out.step.after.stance = stance;
  out.step.placed = stance;
  return out;
}

TEST(Thorax, InTheGroundIsRefused) {
  const Isometry3d standing = adapted().before.base;
  expect_refused(with_thorax(standing * Eigen::Translation3d(0, 0, -0.107)), "the thorax is 0 m from the terrain");
}

// On 45 degrees that fall between its feet the standing robot tips over; its best posture does not.
struct Steep {
  Ground ground{terrain::parse_terrain(bent_ground(45 * kDegree, 45 * kDegree, std::numbers::pi))};
  Posture standing;
  Step best;

  Steep() {
    Collector out;
    standing = shared_planner().start(request_at({0, 0, 0}), parameters(), ground);
    shared_planner().plan(request_at({0, 0, 0}), parameters(), ground, out);
    best = out.steps.at(0);
  }
  std::string refusal(const Step& step, const Posture& before) const {
    const StepVerdict verdict = check_step(shipped_model(), ground.surface(), step, before, {0.0, 100.0, 0.005});
    return verdict.accepted ? "accepted" : verdict.reason;
  }
};

TEST(Steep, APostureThatTipsOverIsRefused) {
  const Steep steep;
  ASSERT_EQ(steep.refusal(steep.best, steep.standing), "accepted");
  Step stays = steep.best;
  stays.motion.clear();
  stays.after = steep.standing;
  stays.placed = steep.standing.stance;
  const std::string reason = steep.refusal(stays, steep.standing);
  EXPECT_NE(reason.find("the posture after tips over: NESM -"), std::string::npos) << reason;
}

// From the best posture to the standing one and back again: both ends stand well, the way does not.
TEST(Steep, AMotionThatLosesItsStabilityOnTheWayIsRefused) {
  const Steep steep;
  Step there_and_back = steep.best;
  std::vector<MotionPoint> back(steep.best.motion.rbegin(), steep.best.motion.rend());
  const double time = steep.best.motion.back().time;
  for (MotionPoint& point : back) point.time = time - point.time;
  for (MotionPoint& point : there_and_back.motion) point.time += time;
  there_and_back.motion.insert(there_and_back.motion.begin(), back.begin(), back.end());
  const std::string reason = steep.refusal(there_and_back, steep.best.after);
  EXPECT_NE(reason.find("on the way"), std::string::npos) << reason;
}

// The bound of a walk is demanded where both ends keep it.
TEST(Motion, OfAWalkKeepsItsBound) {
  Judged half = walked().at(1);
  const StepVerdict sound = verdict_of(half);
  ASSERT_TRUE(sound.accepted);
  half.options.least_nesm = sound.margins.back().value + 1e-4;
  expect_refused(half, "m are demanded");
}

// The feet that hold are not told: those that are told lift.
TEST(Motion, WhoseFeetAllLiftIsRefused) {
  Judged half = walked().at(1);
  for (auto* stance : {&half.before.stance, &half.step.after.stance})
    std::erase_if(*stance, [&](const Contact& c) {
      return std::none_of(half.step.placed.begin(), half.step.placed.end(), [&](const Contact& p) { return p.limb == c.limb; });
    });
  expect_refused(half, "only 0 feet hold");
}

}  // namespace
}  // namespace foothold::hexpiderix::testing
