// Plans as JSON: every bit comes back, and what is not a plan is refused by name.
#include "foothold/client/plan_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "random_message.hpp"

namespace foothold::test {
namespace {

using client::plan_from_json;
using client::plan_to_json;
using client::PlanFileError;
using client::PlanRecord;

PlanRecord random_plan(std::uint64_t seed) {
  RandomContents random(seed);
  return {random.make<msg::PlanRequest>(), random.make<msg::PlanEvent>(), random.make<std::vector<msg::Shape>>(),
          random.make<std::vector<msg::Step>>()};
}

void expect_equal(const PlanRecord& a, const PlanRecord& b) {
  EXPECT_EQ(a.request, b.request);
  EXPECT_EQ(a.final_event, b.final_event);
  EXPECT_EQ(a.scene, b.scene);
  EXPECT_EQ(a.steps, b.steps);
}

TEST(PlanFile, RandomPlansComeBackEqual) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const PlanRecord plan = random_plan(seed);
    const std::string text = plan_to_json(plan);
    const PlanRecord back = plan_from_json(text, "plan.json");
    expect_equal(plan, back);
    EXPECT_EQ(plan_to_json(back), text) << "seed " << seed;
    if (HasFailure()) break;
  }
}

TEST(PlanFile, NumbersThatAreNotFiniteAndMinusZeroComeBack) {
  PlanRecord plan;
  plan.steps.resize(1);
  plan.steps[0].joints({std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN(), -0.0});
  const auto joints = plan_from_json(plan_to_json(plan), "plan.json").steps[0].joints();
  ASSERT_EQ(joints.size(), 4u);
  EXPECT_EQ(joints[0], std::numeric_limits<double>::infinity());
  EXPECT_EQ(joints[1], -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(joints[2]));
  EXPECT_TRUE(std::signbit(joints[3]) && joints[3] == 0.0);
}

TEST(PlanFile, AWrittenFileReadsBackEqual) {
  const std::string path = testing::TempDir() + "plan_file_test.json";
  const PlanRecord plan = random_plan(7);
  client::write_plan_file(path, plan);
  expect_equal(plan, client::read_plan_file(path));
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  std::filesystem::remove(path);
}

std::string error_of(const std::string& text) {
  try {
    plan_from_json(text, "plan.json");
  } catch (const PlanFileError& error) {
    return error.what();
  }
  return "was accepted";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST(PlanFile, RefusesWithThePlaceAndTheReason) {
  PlanRecord plan;
  plan.request.robot("xrobin");
  plan.request.seed(5);
  plan.steps.resize(2);
  plan.steps[1].index(1);
  plan.final_event.state(msg::SUCCEEDED);
  const std::string good = plan_to_json(plan);
  expect_equal(plan, plan_from_json(good, "plan.json"));

  EXPECT_EQ(error_of(good.substr(0, good.size() / 2)).find("plan.json: line "), 0u);
  EXPECT_EQ(error_of("[]"), "plan.json: expected an object, not array");
  EXPECT_EQ(error_of(replaced(good, "foothold-plan", "other")), "plan.json: format: expected \"foothold-plan\", not \"other\"");
  EXPECT_EQ(error_of(replaced(good, "\"version\": 1", "\"version\": 2")),
            "plan.json: version: this program reads version 1, not 2");
  EXPECT_EQ(error_of(replaced(good, "\"scene\": []", "\"scnee\": []")), "plan.json: scnee: is not known; did you mean 'scene'?");
  EXPECT_EQ(error_of(replaced(good, "\"seed\":5", "\"seed\":-5")), "plan.json: request.seed: -5 does not fit");
  EXPECT_EQ(error_of(replaced(good, "\"seed\":5", "\"seed\":5.5")), "plan.json: request.seed: expected an integer, not 5.5");
  EXPECT_EQ(error_of(replaced(good, "\"robot\":\"xrobin\"", "\"robt\":\"xrobin\"")), "plan.json: request.robot: is missing");
  EXPECT_EQ(error_of(replaced(good, "\"robot\":\"xrobin\"", "\"robot\":7")), "plan.json: request.robot: expected a string, not 7");
  EXPECT_EQ(error_of(replaced(good, "\"index\":1", "\"index\":1,\"indx\":1")),
            "plan.json: steps[1].indx: is not known; did you mean 'index'?");
  EXPECT_EQ(error_of(replaced(good, "\"SUCCEEDED\"", "\"SUCCEDED\"")),
            "plan.json: final_event.state: 'SUCCEDED' is none of its values; did you mean 'SUCCEEDED'?");
  EXPECT_EQ(error_of(replaced(good, "\"shapes\":false", "\"shapes\":0")),
            "plan.json: request.shapes: expected true or false, not 0");
}

TEST(PlanFile, SaysWhyAFileCannotBeReadOrWritten) {
  try {
    client::read_plan_file("/nowhere/plan.json");
    FAIL();
  } catch (const PlanFileError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/plan.json: cannot be read: No such file or directory");
  }
  EXPECT_THROW(client::read_plan_file(testing::TempDir()), PlanFileError);
  EXPECT_THROW(client::write_plan_file("/nowhere/plan.json", {}), PlanFileError);
}

TEST(PlanFile, AStepIsOneLine) {
  msg::Step step;
  step.label("two\nlines");
  const std::string line = client::to_json_line(step);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(line.find("{\"step\":{\"request\":"), 0u);
}

}  // namespace
}  // namespace foothold::test
