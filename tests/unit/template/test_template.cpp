// The template's plans reach the goal in the fewest steps, its judge accepts them and nothing else.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "foothold/robot_file.hpp"
#include "planner.hpp"

namespace foothold::biped {
namespace {

using Outcome = PlanReport::Outcome;

// In the place of the worker: judges each step with the planner's own check().
class Judge final : public PlanContext {
 public:
  Judge(const BipedPlanner& planner, Posture start, const Parameters& parameters)
      : planner_(planner), before_(std::move(start)), parameters_(parameters) {}
  bool emit(Step step) override {
    if (steps.size() == most) return false;
    const StepVerdict verdict = planner_.check(step, before_, parameters_, PreparedScene());
    EXPECT_TRUE(verdict.accepted) << "step " << steps.size() << ": " << verdict.reason;
    for (const Margin& margin : verdict.margins) EXPECT_GE(margin.value, margin.least) << margin.name;
    before_ = step.after;
    steps.push_back(std::move(step));
    return verdict.accepted;
  }
  std::vector<Step> steps;
  std::size_t most = 100000;

 private:
  const BipedPlanner& planner_;
  Posture before_;
  const Parameters& parameters_;
};

class Template : public ::testing::Test {
 protected:
  struct Plan {
    PlanReport report;
    std::vector<Step> steps;
  };
  Plan plan(std::size_t most = 100000) {
    Judge judge(planner, planner.start(request, parameters, scene), parameters);
    judge.most = most;
    PlanReport report = planner.plan(request, parameters, scene, judge);
    return {std::move(report), std::move(judge.steps)};
  }
  void go_to(double x, double y) {
    request.goal.base = Isometry3d::Identity();
    request.goal.base->translation() << x, y, 0.0;
  }
  void set_parameters(double stride, const char* first) {
    parameters = Parameters({{"stride", stride}, {"first", std::string(first)}});
  }
  std::string refused_field() {
    try {
      plan();
    } catch (const InvalidRequest& fault) {
      return fault.field();
    }
    return "(none)";
  }

  RobotModel model = load_robot_model(FOOTHOLD_ROBOT_FILE);
  Biped biped{model};
  BipedPlanner planner{model};
  PreparedScene scene;
  Request request;
  Parameters parameters{{{"stride", 1.0}, {"first", std::string("left")}}};
};

TEST_F(Template, ReachesTheGoalInTheFewestSteps) {
  go_to(1.0, 0.0);
  const Plan made = plan();
  EXPECT_EQ(made.report.outcome, Outcome::kReached);
  EXPECT_TRUE(made.report.optimal);
  // 1 m in advances of 0.15 m at most, and one step for the other foot.
  EXPECT_EQ(made.steps.size(), 8u);
  EXPECT_EQ(made.report.cost, 8.0);
  EXPECT_TRUE(made.steps.back().after.base.isApprox(*request.goal.base, 1e-9));
  EXPECT_EQ(made.steps[0].placed[0].limb, "left");
  EXPECT_EQ(made.steps[1].placed[0].limb, "right");
}

TEST_F(Template, ReachesRandomGoalsFromRandomStarts) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-3.0, 3.0), share(0.05, 1.0), turn(-3.0, 3.0);
  for (int i = 0; i < 300; ++i) {
    set_parameters(share(random), i % 2 == 0 ? "left" : "right");
    go_to(place(random), place(random));
    request.start.base = Isometry3d::Identity();
    request.start.base->translation() << place(random), place(random), 0.0;
    request.start.base->rotate(Eigen::AngleAxisd(turn(random), Vector3d::UnitZ()));
    request.goal.base->linear() = request.start.base->linear();
    const Plan made = plan();
    ASSERT_EQ(made.report.outcome, Outcome::kReached);
    ASSERT_FALSE(made.steps.empty());
    EXPECT_TRUE(made.report.optimal);
    EXPECT_TRUE(made.steps.back().after.base.isApprox(*request.goal.base, 1e-9));
  }
}

TEST_F(Template, DoesNotClaimTheOptimumWhereRoundingCostsItAStep) {
  go_to(1.5, 0.0);  // ten times its reach
  const Plan made = plan();
  EXPECT_EQ(made.report.cost, 12.0);
  EXPECT_EQ(made.report.lower_bound, 11.0);
  EXPECT_FALSE(made.report.optimal);
}

TEST_F(Template, IsThereAlready) {
  go_to(0.0, 0.0);
  EXPECT_EQ(plan().report.outcome, Outcome::kReached);
  EXPECT_TRUE(plan().steps.empty());
}

TEST_F(Template, StopsWhenNothingMoreIsWanted) {
  go_to(5.0, 1.0);
  const Plan made = plan(3);
  EXPECT_EQ(made.report.outcome, Outcome::kStopped);
  EXPECT_EQ(made.steps.size(), 3u);
}

TEST_F(Template, RefusesWhatItCannotDoByField) {
  EXPECT_EQ(refused_field(), "goal.base");
  go_to(1.0, 0.0);
  request.goal.base->translation().z() = 0.3;
  EXPECT_EQ(refused_field(), "goal.base.position.z");
  go_to(1.0, 0.0);
  request.goal.base->rotate(Eigen::AngleAxisd(0.5, Vector3d::UnitZ()));
  EXPECT_EQ(refused_field(), "goal.base.orientation");
  request.goal.any_orientation = true;
  EXPECT_EQ(refused_field(), "(none)");
  request.start.contacts.resize(1);
  EXPECT_EQ(refused_field(), "start.contacts");
  request.start.contacts.clear();
  request.goal.joints = {0.1};
  EXPECT_EQ(refused_field(), "goal.joints");
  EXPECT_THROW(planner.prepare({.name = "hall", .revision = "", .format = "yaml", .path = "/hall.yaml"}, parameters), InvalidScene);
}

TEST_F(Template, TheJudgeRefusesEveryKindOfBadStep) {
  go_to(1.0, 0.4);
  const Plan made = plan();
  const Posture before = made.steps[1].after;
  const Step& good = made.steps[2];
  ASSERT_TRUE(planner.check(good, before, parameters, scene).accepted);
  const auto shift = [](Step& step, double x, double y, double z) {
    for (Isometry3d* frame : {&step.after.stance[kLeft].frame, &step.placed[0].frame}) frame->translation() += Vector3d(x, y, z);
    step.after.base.translation() += 0.5 * Vector3d(x, y, z);
  };
  const std::pair<const char*, std::function<void(Step&)>> faults[] = {
      {"reach", [&](Step& step) { shift(step, 0.1, 0.0, 0.0); }},
      {"ground", [&](Step& step) { shift(step, 0.0, 0.0, 0.01); }},
      {"carries", [](Step& step) { step.after.stance[kRight].frame.translation().x() += 0.01; }},
      {"placed", [](Step& step) { step.placed[0].frame.translation().x() += 0.01; }},
      {"middle", [](Step& step) { step.after.base.translation().x() += 0.01; }},
      {"two feet", [](Step& step) { step.after.stance.pop_back(); }},
      {"one foot", [](Step& step) { step.placed.push_back(step.placed[0]); }}};
  for (const auto& [word, spoil] : faults) {
    Step step = good;
    spoil(step);
    const StepVerdict verdict = planner.check(step, before, parameters, scene);
    EXPECT_FALSE(verdict.accepted) << word;
    EXPECT_NE(verdict.reason.find(word), std::string::npos) << verdict.reason;
  }
}

TEST_F(Template, AModelWhoseSolesCouldMeetIsRefused) {
  auto quantities = model.quantities();
  quantities.at("reach").values = {0.2};
  try {
    BipedPlanner wrong{RobotModel(quantities)};
    ADD_FAILURE() << "was taken";
  } catch (const InvalidModel& fault) {
    EXPECT_EQ(fault.field(), "reach");
  }
  quantities.at("reach").values = {0.0};
  EXPECT_THROW(BipedPlanner{RobotModel(quantities)}, InvalidModel);
}

TEST_F(Template, ShapesStandOnTheGround) {
  const auto shapes = planner.shapes(biped.standing(Isometry3d::Identity()));
  ASSERT_EQ(shapes.size(), 3u);
  for (const Shape& shape : shapes) EXPECT_GE(shape.pose.translation().z() - 0.5 * shape.size.z(), -1e-12) << shape.body;
}

}  // namespace
}  // namespace foothold::biped
