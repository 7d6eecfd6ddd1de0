// Walks whose single supports are found by the paper's methods, judged step by step.
#include <gtest/gtest.h>

#include "planning.hpp"

namespace foothold::bioloid::testing {
namespace {

PlanReport planned(const Set& set, Collector& out, double ahead = 0.10) {
  const Parameters values = parameters(set);
  BioloidPlanner& planner = shared_planner();
  return judged_plan(planner, walk_request(on_floor(0.0, 0.0, 0.0), on_floor(ahead, 0.0, 0.0)), values,
                     *planner.prepare({}, values), out);
}

double figure(const PlanReport& report, const std::string& name) {
  for (const Margin& figure : report.figures)
    if (figure.name == name) return figure.value;
  ADD_FAILURE() << "no figure " << name;
  return 0.0;
}

TEST(PaperMethods, StochasticWalksAsOptimalDoesAndSaysWhatItTook) {
  Collector steps(1), optimal(1);
  const PlanReport report = planned({{"method", "stochastic"}, {"trials", "3"}}, steps);
  ASSERT_EQ(report.outcome, PlanReport::Outcome::kReached) << report.message;
  EXPECT_EQ(planned({}, optimal).cost, report.cost) << "the footsteps are the same";
  EXPECT_GE(figure(report, "trials"), 3.0);
  EXPECT_GE(figure(report, "iterations"), figure(report, "movements"));
  EXPECT_GT(figure(report, "movements"), 0.0);
}

TEST(PaperMethods, TheChoiceAmongTrialsIsTheRequests) {
  for (const char* choice : {"iterations", "error", "variance"}) {
    Collector steps(1);
    EXPECT_EQ(planned({{"method", "stochastic"}, {"trials", "2"}, {"choose", choice}}, steps).outcome,
              PlanReport::Outcome::kReached);
  }
}

TEST(PaperMethods, RandomGivesUpAfterItsIterationsAndSaysSo) {
  Collector steps(1);
  const PlanReport report = planned({{"method", "random"}, {"iterations", "2000"}}, steps);
  EXPECT_EQ(report.outcome, PlanReport::Outcome::kFailed);
  EXPECT_EQ(report.error, PlanError::kSearchLimit);
  EXPECT_EQ(report.field, "parameters.method");
  EXPECT_NE(report.message.find("2000 iterations"), std::string::npos) << report.message;
  EXPECT_TRUE(steps.steps.empty());
}

}  // namespace
}  // namespace foothold::bioloid::testing
