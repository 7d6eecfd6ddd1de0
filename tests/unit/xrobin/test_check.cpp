// The judge of steps: accepts what the planner emits, refuses every way in which a step can lie.
#include <gtest/gtest.h>

#include <functional>

#include "check.hpp"
#include "fixtures.hpp"
#include "route.hpp"

namespace foothold::xrobin {
namespace {

class Check : public testing::Test {
 protected:
  // The third of some steps, changed by `change`, judged; the reason of its refusal.
  std::string reason_after(const std::function<void(Step&)>& change) {
    Step step = steps_[2];
    change(step);
    const StepVerdict verdict = check_step(ring_.mechanism().lengths(), step, steps_[1].after);
    return verdict.accepted ? "accepted" : verdict.reason;
  }
  static void shift(Isometry3d& frame, double by) { frame.translation().x() += by; }

  const Ring ring_{mechanism()};
  const Stance start_{{0.1, -0.2, 0.3}, 1};
  const Word word_{2, 5, 8, 3, 6, 1};
  const std::vector<Step> steps_ = to_steps(ring_, start_, shortest_ways(1, word_), 0, 0.4);
};

TEST_F(Check, AcceptsEveryStepOfEveryWay) {
  for (int from = 1; from <= 8; ++from)
    for (int to = 1; to <= 8; ++to)
      for (const RingWay way : {RingWay::kUp, RingWay::kDown})
        for (const std::size_t half : {0u, 1u}) {
          const Stance start{{0.4, 0.1, -2.0}, from};
          const std::vector<Step> steps = to_steps(ring_, start, {{to, way}}, half, 0.4);
          const StepVerdict verdict = check_step(ring_.mechanism().lengths(), steps[0], posture(ring_.mechanism(), start));
          EXPECT_TRUE(verdict.accepted) << from << " to " << to << ": " << verdict.reason;
          ASSERT_EQ(verdict.margins.size(), 1u);
          EXPECT_GE(verdict.margins[0].value, verdict.margins[0].least);
        }
  EXPECT_EQ(reason_after([](Step&) {}), "accepted");
}

TEST_F(Check, RefusesABodyThatHoldsAndMoves) {
  EXPECT_NE(reason_after([](Step& s) {
              shift(s.after.stance[0].frame, 1e-5), shift(s.after.base, 1e-5);
            }).find("body A holds, but moves"),
            std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { shift(s.motion[3].base, 1e-5); }).find("body A holds, but moves"), std::string::npos);
}

TEST_F(Check, RefusesABodyBesideItsSlotOrPlacedElsewhere) {
  EXPECT_NE(reason_after([](Step& s) {
              shift(s.after.stance[1].frame, 1e-5);
              s.placed[0] = s.after.stance[1];
            }).find("beside the slot"),
            std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { shift(s.placed[0].frame, 1e-5); }).find("placed where it is not"), std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { shift(s.after.base, 1e-5); }).find("base"), std::string::npos);
  EXPECT_NE(reason_after([](Step& s) {
              s.after.stance[1].frame.translation().z() = 0.01, s.placed[0] = s.after.stance[1];
            }).find("plane"),
            std::string::npos);
}

TEST_F(Check, RefusesPistonsOfOtherLengths) {
  EXPECT_NE(reason_after([](Step& s) { s.after.joints[0] += 1e-5; }).find("piston l"), std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { s.after.joints.pop_back(); }).find("two piston lengths"), std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { s.motion[2].joints.clear(); }).find("two piston lengths"), std::string::npos);
}

TEST_F(Check, RefusesAPostureBetweenTwoConfigurations) {
  // A closed chain, but with a piston that is neither retracted nor extended.
  Step step = steps_[0];
  const SlotPosture half = ring_.at(ring_.edge(1), 0.5 * ring_.edge(1).phi_to);
  const Pistons lengths = ring_.mechanism().pistons(half.phi, half.y);
  step.motion.resize(5);
  step.motion.back().joints = {lengths.l, lengths.r};
  step.after.joints = {lengths.l, lengths.r};
  step.after.stance[1].frame = contact_frame(start_.a * PlanarPose{0.0, half.y, half.phi});
  step.placed[0] = step.after.stance[1];
  const StepVerdict verdict = check_step(ring_.mechanism().lengths(), step, posture(ring_.mechanism(), start_));
  EXPECT_FALSE(verdict.accepted);
  EXPECT_NE(verdict.reason.find("neither retracted nor extended"), std::string::npos) << verdict.reason;
}

TEST_F(Check, RefusesMotionsThatAreNone) {
  EXPECT_NE(reason_after([](Step& s) { s.motion.clear(); }).find("no motion is given"), std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { s.motion.pop_back(); }).find("motion ends"), std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { s.motion.erase(s.motion.begin() + 2, s.motion.begin() + 6); }).find("leaps"),
            std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { s.motion[3].time = 0.0; }).find("time runs backwards"), std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { s.motion[3].time = std::nan(""); }).find("time runs backwards"), std::string::npos);
}

TEST_F(Check, RefusesBothPistonsAtOnce) {
  // From configuration 1 to 3 straight in (phi, y): the chain is closed at every point, but both pistons change.
  const Mechanism& m = ring_.mechanism();
  Step step = to_steps(ring_, start_, {{3, RingWay::kUp}}, 0, 0.4)[0];
  step.motion.clear();
  for (int k = 0; k <= 40; ++k) {
    const double part = k / 40.0;
    const Pistons p = m.pistons(part * m.configuration(3).phi, (1.0 - part) * m.configuration(1).y);
    step.motion.push_back({part, to_world(start_.a), {p.l, p.r}});
  }
  const StepVerdict verdict = check_step(m.lengths(), step, posture(m, start_));
  EXPECT_FALSE(verdict.accepted);
  EXPECT_NE(verdict.reason.find("both pistons"), std::string::npos) << verdict.reason;
}

TEST_F(Check, RefusesStepsWithoutTheirContacts) {
  EXPECT_NE(reason_after([](Step& s) { s.placed.clear(); }).find("one body is placed"), std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { s.placed[0].limb = "C"; }).find("no body 'C'"), std::string::npos);
  EXPECT_NE(reason_after([](Step& s) { s.after.stance.pop_back(); }).find("not among the contacts"), std::string::npos);
}

TEST_F(Check, RefusesStepsThatTouchAnObstacleAtRestOrOnTheWay) {
  const Mechanism& m = ring_.mechanism();
  const Bodies bodies = Bodies::from_model(robot(), m);
  const Stance start{{0, 0, 0}, 1};
  // B turns by 90 deg from configuration 1 to 3: its ends sweep the corners, where it rests neither before nor after.
  const Step step = to_steps(ring_, start, {{3, RingWay::kUp}}, 0, 0.4)[0];
  const auto judged = [&](const geometry::Polygon& polygon) {
    return check_step_among(m.lengths(), bodies, {{"post", polygon}}, 0.001, step, posture(m, start));
  };
  const auto square = [](double x, double y) {
    return geometry::Polygon{{x - 0.002, y - 0.002}, {x + 0.002, y - 0.002}, {x + 0.002, y + 0.002}, {x - 0.002, y + 0.002}};
  };
  EXPECT_NE(judged(square(0.0, 0.05)).reason.find("'post'"), std::string::npos);   // inside B before
  EXPECT_NE(judged(square(0.0, -0.09)).reason.find("'post'"), std::string::npos);  // inside B after
  EXPECT_NE(judged(square(0.075, -0.055)).reason.find("'post'"), std::string::npos);
  const StepVerdict beside = judged(square(0.12, -0.12));
  EXPECT_TRUE(beside.accepted) << beside.reason;
  ASSERT_EQ(beside.margins.size(), 2u);
  EXPECT_EQ(beside.margins[1].name, "clearance");
  EXPECT_GT(beside.margins[1].value, 0.0);
}

}  // namespace
}  // namespace foothold::xrobin
