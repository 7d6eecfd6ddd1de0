// Reports that contradict themselves are not passed on; the others arrive whole.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "worker/report.hpp"

namespace foothold::server {
namespace {

using Outcome = PlanReport::Outcome;

PlanReport sound() {
  PlanReport report;
  report.outcome = Outcome::kReached;
  report.cost = 2.0;
  report.lower_bound = 1.5;
  report.cost_unit = "m";
  report.objective = "length";
  report.figures = {{"left", 0.1, 0.2, "m"}};
  return report;
}

TEST(Report, ASoundOneArrivesWhole) {
  const frame::Report told = to_report(sound(), false);
  EXPECT_EQ(told.state(), msg::SUCCEEDED);
  EXPECT_EQ(told.reason().code(), msg::NO_ERROR);
  EXPECT_EQ(told.summary().cost(), 2.0);
  EXPECT_EQ(told.summary().lower_bound(), 1.5);
  EXPECT_EQ(told.summary().cost_unit(), "m");
  EXPECT_EQ(told.summary().objective(), "length");
  ASSERT_EQ(told.summary().figures().size(), 1u);
  EXPECT_EQ(told.summary().figures()[0].value(), 0.1);
}

TEST(Report, AFailureCarriesItsErrorFieldAndHint) {
  PlanReport report = sound();
  report.outcome = Outcome::kPartial;
  report.error = PlanError::kToleranceNotMet;
  report.field = "goal.base.position";
  report.message = "0.1 m left";
  report.hint = "more cycles";
  const frame::Report told = to_report(report, false);
  EXPECT_EQ(told.state(), msg::PARTIAL);
  EXPECT_EQ(told.reason().code(), msg::TOLERANCE_NOT_MET);
  EXPECT_EQ(told.reason().name(), "TOLERANCE_NOT_MET");
  EXPECT_EQ(told.reason().field(), "goal.base.position");
  EXPECT_EQ(told.reason().message(), "0.1 m left");
  EXPECT_EQ(told.reason().hint(), "more cycles");
  EXPECT_EQ(told.summary().cost(), 2.0);
}

TEST(Report, APluginsOwnErrorKeepsItsNumberAndName) {
  PlanReport report = sound();
  report.outcome = Outcome::kFailed;
  report.own_error = 907;
  report.error_name = "GRIPPER_STUCK";
  const frame::Report told = to_report(report, false);
  EXPECT_EQ(told.state(), msg::FAILED);
  EXPECT_EQ(told.reason().code(), 907);
  EXPECT_EQ(told.reason().name(), "GRIPPER_STUCK");
  EXPECT_EQ(told.reason().stage(), "search");
}

TEST(Report, AStoppedPlanIsCancelled) {
  PlanReport report;
  report.outcome = Outcome::kStopped;
  EXPECT_EQ(to_report(report, true).state(), msg::CANCELLED);
}

TEST(Report, ABoundThatDiffersInTheLastDigitsIsNoLie) {
  PlanReport report = sound();
  report.optimal = true;
  report.lower_bound = 2.0 * (1.0 + 1e-12);
  EXPECT_EQ(contradiction(report, false), std::nullopt);
}

TEST(Report, APartialPlanMayCostLessThanAnyThatReachesTheGoal) {
  PlanReport report = sound();
  report.outcome = Outcome::kPartial;
  report.error = PlanError::kNoPath;
  report.lower_bound = 5.0;
  EXPECT_EQ(contradiction(report, false), std::nullopt);
}

TEST(Report, EachContradictionIsASentenceWithTheValues) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  struct Lie {
    std::function<void(PlanReport&)> change;
    const char* words;
  };
  const Lie lies[] = {{[](PlanReport& r) { r.optimal = true; }, "optimal with cost 2 and lower bound 1.5"},
                      {[](PlanReport& r) { r.lower_bound = 3.0; }, "cost 2 and lower bound 3"},
                      {[&](PlanReport& r) { r.cost = kNan; }, "cost that is not finite"},
                      {[&](PlanReport& r) { r.lower_bound = -kInfinity; }, "lower bound that is not finite"},
                      {[&](PlanReport& r) { r.figures[0].value = kNan; }, "'left'"},
                      {[](PlanReport& r) { r.outcome = Outcome::kStopped; }, "nobody told it to"},
                      {[](PlanReport& r) { r.outcome = Outcome::kFailed; }, "without saying why"},
                      {[](PlanReport& r) { r.outcome = Outcome::kPartial; }, "without saying why"},
                      {[](PlanReport& r) { r.error = PlanError::kNoPath; }, "together with an error"},
                      {[](PlanReport& r) { r.own_error = 899; }, "899"},
                      {[](PlanReport& r) { r.error = static_cast<PlanError>(407); }, "407"},
                      {[](PlanReport& r) { r.error = static_cast<PlanError>(503); }, "503"},
                      {[](PlanReport& r) { r.outcome = static_cast<Outcome>(9); }, "outcome number 9"},
                      {[](PlanReport& r) {
                         r.outcome = Outcome::kFailed;
                         r.error = PlanError::kNoPath;
                         r.optimal = true;
                       },
                       "optimal without a plan"}};
  for (const Lie& lie : lies) {
    PlanReport report = sound();
    lie.change(report);
    const auto sentence = contradiction(report, false);
    ASSERT_TRUE(sentence.has_value()) << lie.words;
    EXPECT_NE(sentence->find(lie.words), std::string::npos) << *sentence;
    const frame::Report told = to_report(report, false);
    EXPECT_EQ(told.state(), msg::FAILED);
    EXPECT_EQ(told.reason().code(), msg::WORKER_PROTOCOL);
    EXPECT_EQ(told.summary().cost(), 0.0) << "nothing of it is passed on";
  }
}

}  // namespace
}  // namespace foothold::server
