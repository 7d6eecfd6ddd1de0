// A plan through a real worker process: what comes back, and what the planner was given.
#include <algorithm>
#include <random>

#include "fixture.hpp"

namespace foothold::server::test {
namespace {

using namespace std::chrono_literals;

std::string attribute(const msg::Step& step, const std::string& name) {
  for (const msg::Attribute& attribute : step.attributes())
    if (attribute.name() == name) return attribute.value();
  return "(none)";
}

TEST(Workers, APlanComesBackStepByStepWithItsSummary) {
  Rig rig;
  rig.open({Rig::robot("many")});
  const auto status = rig.workers->status("many");
  ASSERT_TRUE(status.info);
  EXPECT_EQ(status.info->state(), msg::READY);
  EXPECT_EQ(status.info->plugin(), "many");
  EXPECT_EQ(status.info->parameters().size(), 3u);
  EXPECT_EQ(status.info->limbs(), (std::vector<std::string>{"left", "right"}));

  const Heard& heard = rig.plan(Rig::request("many", {{"steps", "25"}}));
  ASSERT_EQ(heard.ends.size(), 1u);
  const RunEnd& end = heard.ends[0];
  EXPECT_EQ(end.kind, RunEnd::Kind::kReport);
  EXPECT_EQ(end.state, msg::SUCCEEDED) << end.error.message();
  ASSERT_EQ(heard.steps.size(), 25u);
  EXPECT_EQ(end.summary.steps(), 25u);
  EXPECT_TRUE(end.summary.optimal());
  EXPECT_EQ(end.summary.parameters().size(), 3u);
  EXPECT_EQ(end.summary.parameters()[1].value(), "0") << "the default is filled in";
  EXPECT_NEAR(heard.steps[24].base().position().x(), 2.5, 1e-9);
  ASSERT_EQ(heard.steps[24].margins().size(), 1u);
  EXPECT_EQ(heard.steps[24].margins()[0].name(), "advance");
  EXPECT_TRUE(rig.workers->has_idle("many"));
  EXPECT_EQ(rig.workers->status("many").info, status.info) << "nothing changed: the same object";
}

TEST(Workers, AnUnknownRobotIsUnknown) {
  Rig rig;
  rig.open({Rig::robot("many")});
  EXPECT_FALSE(rig.workers->status("nobody").info);
  EXPECT_FALSE(rig.workers->has_idle("nobody"));
  EXPECT_FALSE(rig.workers->reload("nobody"));
}

TEST(Workers, ARobotThatIsNotEnabledIsLeftOut) {
  Rig rig;
  RobotConfig off = Rig::robot("many");
  off.enabled = false;
  rig.open({off});
  EXPECT_FALSE(rig.workers->status("many").info);
}

TEST(Workers, EachSlotPlansAtTheSameTime) {
  Rig rig;
  rig.open({Rig::robot("heed", 3)});
  std::vector<server::Run> runs;
  while (rig.workers->has_idle("heed")) runs.push_back(rig.start(Rig::request("heed")));
  EXPECT_EQ(runs.size(), 3u);
  rig.run_until([&] { return std::ranges::all_of(runs, [&](auto run) { return rig.heard[run].steps.size() == 1; }); });
  for (const auto run : runs) rig.workers->stop(run);
  for (const auto run : runs) EXPECT_EQ(rig.end_of(run).ends[0].state, msg::CANCELLED);
}

TEST(Workers, ThePlannerIsGivenTheWholeRequest) {
  Rig rig;
  rig.open({Rig::robot("recall")});
  msg::PlanRequest request = Rig::request("recall");
  request.unit("serial 7");
  request.seed(99);
  request.budget(4.0);
  request.goal().base().resize(1);
  request.goal().base()[0].position().y(2.5);
  request.goal().base()[0].orientation().w(1.0);
  const Heard& heard = rig.plan(request);
  ASSERT_EQ(heard.steps.size(), 1u) << heard.ends[0].error.message();
  EXPECT_EQ(attribute(heard.steps[0], "unit"), "serial 7");
  EXPECT_EQ(attribute(heard.steps[0], "seed"), "99");
  EXPECT_EQ(attribute(heard.steps[0], "goal"), "2.500000");
  EXPECT_NEAR(std::stod(attribute(heard.steps[0], "budget")), 4.0, 1.0);
  EXPECT_EQ(heard.ends[0].summary.seed(), 99u);
}

TEST(Workers, TheSeedAloneDecidesTheRandomNumbers) {
  Rig rig;
  rig.open({Rig::robot("recall")});
  const auto random_of = [&](std::uint64_t seed) {
    msg::PlanRequest request = Rig::request("recall");
    request.seed(seed);
    return attribute(rig.plan(request).steps.at(0), "random");
  };
  const std::string first = random_of(5);
  EXPECT_NE(random_of(6), first);
  EXPECT_EQ(random_of(5), first);
  EXPECT_EQ(first, std::to_string(std::mt19937_64(5)()));
}

TEST(Workers, ASceneIsPreparedOnceForWhatItDependsOn) {
  Rig rig;
  rig.open({Rig::robot("recall")});
  const StoredScene scene{.name = "bridge", .revision = "aa", .format = "yaml", .path = "/scenes/aa"};
  StoredScene newer = scene;
  newer.revision = "bb";
  const auto prepared = [&](std::optional<StoredScene> in, std::vector<std::pair<std::string, std::string>> parameters) {
    msg::PlanRequest request = Rig::request("recall", std::move(parameters));
    request.scene("bridge");
    const Heard& heard = rig.end_of(rig.start(request, in));
    EXPECT_EQ(heard.ends[0].summary.scene_revision(), in ? in->revision : "");
    return attribute(heard.steps.at(0), "prepared") + " " + attribute(heard.steps.at(0), "path");
  };
  EXPECT_EQ(prepared(scene, {}), "1 /scenes/aa");
  EXPECT_EQ(prepared(scene, {{"other", "true"}}), "1 /scenes/aa");
  EXPECT_EQ(prepared(scene, {{"grid", "0.2"}}), "2 /scenes/aa");
  EXPECT_EQ(prepared(newer, {}), "3 /scenes/aa");
  EXPECT_EQ(prepared(std::nullopt, {}), "4 ");
  EXPECT_EQ(prepared(scene, {}), "1 /scenes/aa");
  // Eight are kept: the least recently used goes.
  for (int i = 0; i < 8; ++i) prepared(scene, {{"grid", "0.3" + std::to_string(i)}});
  EXPECT_EQ(prepared(scene, {}), "13 /scenes/aa");
}

TEST(Workers, ShapesComeIfAskedForTheScenesFirst) {
  Rig rig;
  rig.open({Rig::robot("recall")});
  msg::PlanRequest request = Rig::request("recall");
  request.shapes(true);
  request.scene("bridge");
  const Heard& heard =
      rig.end_of(rig.start(request, StoredScene{.name = "bridge", .revision = "aa", .format = "yaml", .path = "/aa"}));
  ASSERT_TRUE(heard.scene.has_value());
  ASSERT_EQ(heard.scene->size(), 1u);
  EXPECT_EQ(heard.scene->front().body(), "bridge");
  EXPECT_EQ(heard.scene->front().size().z(), 3.0);
  ASSERT_EQ(heard.steps.at(0).shapes().size(), 1u);
  EXPECT_EQ(heard.steps[0].shapes()[0].body(), "body");

  const Heard& without = rig.plan(Rig::request("recall"));
  EXPECT_FALSE(without.scene.has_value());
  EXPECT_TRUE(without.steps.at(0).shapes().empty());
}

TEST(Workers, ParametersOutsideTheSchemaFailWithTheirName) {
  Rig rig;
  rig.open({Rig::robot("many")});
  const auto error_of = [&](const std::string& name, const std::string& value) {
    const RunEnd& end = rig.plan(Rig::request("many", {{name, value}})).ends[0];
    EXPECT_EQ(end.state, msg::FAILED);
    EXPECT_EQ(end.error.field(), "parameters." + name);
    return end.error.code();
  };
  EXPECT_EQ(error_of("speed", "1"), msg::UNKNOWN_PARAMETER);
  EXPECT_EQ(error_of("steps", "-1"), msg::PARAMETER_OUT_OF_RANGE);
  EXPECT_EQ(error_of("steps", "few"), msg::MALFORMED);
}

TEST(Workers, AStopInTheFirstMillisecondIsHeard) {
  Rig rig;
  rig.open({Rig::robot("heed")});
  for (int i = 0; i < 20; ++i) {
    const auto run = rig.start(Rig::request("heed"));
    rig.workers->stop(run);
    EXPECT_EQ(rig.end_of(run).ends[0].state, msg::CANCELLED);
  }
}

TEST(Workers, AStopOfARunThatHasEndedStopsNoOther) {
  Rig rig;
  rig.open({Rig::robot("many")});
  const auto first = rig.start(Rig::request("many", {{"steps", "1"}}));
  rig.end_of(first);
  const auto second = rig.start(Rig::request("many", {{"steps", "30"}, {"pause_us", "2000"}}));
  rig.workers->stop(first);
  rig.workers->kill(first, "late");
  EXPECT_EQ(rig.end_of(second).ends[0].state, msg::SUCCEEDED);
}

TEST(Workers, AFloodIsStoppedAndTheLoopGoesOnMeanwhile) {
  Rig rig;
  rig.open({Rig::robot("flood"), Rig::robot("many")});
  const auto flood = rig.start(Rig::request("flood"));
  rig.run_until([&] { return rig.heard[flood].steps.size() > 1000; });
  EXPECT_EQ(rig.plan(Rig::request("many", {{"steps", "5"}})).ends[0].state, msg::SUCCEEDED);
  EXPECT_TRUE(rig.heard[flood].ends.empty());
  rig.workers->stop(flood);
  const Heard& heard = rig.end_of(flood);
  EXPECT_EQ(heard.ends[0].state, msg::CANCELLED);
  EXPECT_EQ(heard.ends[0].summary.steps(), heard.steps.size());
}

TEST(Workers, ClosingLetsEveryWorkerLeave) {
  Rig rig;
  rig.open({Rig::robot("many", 2), Rig::robot("heed")});
  bool gone = false;
  rig.workers->close([&] { gone = true; });
  EXPECT_FALSE(rig.workers->has_idle("many"));
  rig.run_until([&] { return gone; });
  EXPECT_TRUE(rig.workers->pids("many").empty());
}

TEST(Workers, ClosingWaitsForNoRun) {
  Rig rig;
  rig.open({Rig::robot("hang")});
  const auto run = rig.start(Rig::request("hang"));
  rig.run_until([&] { return rig.heard[run].steps.size() == 1; });
  bool gone = false;
  rig.workers->close([&] { gone = true; });
  rig.run_until([&] { return gone; });
  EXPECT_EQ(rig.heard[run].ends.at(0).error.code(), msg::WORKER_KILLED);
}

}  // namespace
}  // namespace foothold::server::test
