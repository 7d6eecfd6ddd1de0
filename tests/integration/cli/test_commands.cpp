// `foothold` against the real daemon: what it prints and what it exits with.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

#include <fstream>
#include <memory>
#include <regex>
#include <sstream>

#include "daemon.hpp"
#include "eventually.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/msg/cdr.hpp"
#include "foothold/msg/ids.hpp"
#include "planners.hpp"
#include "program.hpp"

namespace foothold::test {
namespace {

constexpr std::uint32_t kDomain = 17;

class Commands : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    daemon_ = std::make_unique<Daemon>(DaemonOptions{
        .domain = kDomain,
        .robots = {good_robot("walker", 2), bad_robot("crash"), bad_robot("throw"), bad_robot("heed"), bad_robot("hang")},
        .more = kNeverQuarantine});
  }
  static void TearDownTestSuite() {
    EXPECT_EQ(daemon_->stop(), 0);
    daemon_.reset();
  }
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / "foothold_commands";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Printed foothold(const std::string& arguments) { return run("cyclone", kDomain, arguments); }
  std::string file(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::string request(const std::string& robot, const std::string& more = "") {
    return file("request.yaml", "robot: " + robot + "\ngoal: {base: {position: [1, 0, 0], heading_deg: 0}}\nbudget: 20\n" + more);
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }

  static std::unique_ptr<Daemon> daemon_;
  std::filesystem::path folder_;
};

std::unique_ptr<Daemon> Commands::daemon_;

std::string id_in(const std::string& text) {
  std::smatch match;
  return std::regex_search(text, match, std::regex("[0-9a-f]{32}")) ? match.str() : "";
}

TEST_F(Commands, RobotsListsWhatTheServerPlansForAndWithWhatParameters) {
  const Printed list = foothold("robots");
  EXPECT_EQ(list.code, 0) << list.text;
  for (const char* name : {"walker", "crash", "throw", "heed", "hang"}) EXPECT_TRUE(list.has(name)) << list.text;
  const Printed one = foothold("robots walker");
  EXPECT_TRUE(one.has("pause_us") && one.has("0 to 1e+06 us") && one.has("Idle time before each step.")) << one.text;
  EXPECT_FALSE(one.has("crash"));
  const Printed json = foothold("--json robots walker");
  EXPECT_EQ(json.text.find("{\"robot\":{"), 0u);
  EXPECT_EQ(foothold("robots nobody --timeout 1").code, 1);
}

TEST_F(Commands, PlanPrintsEachStepAndHowToHaveThePlanAgain) {
  const Printed plan = foothold("plan " + request("walker") + " --set steps=3 --seed 7 -o " + at("plan.json"));
  EXPECT_EQ(plan.code, 0) << plan.text;
  EXPECT_TRUE(plan.has("SUCCEEDED  3 steps")) << plan.text;
  for (const char* index : {"\n   0  ", "\n   1  ", "\n   2  "}) EXPECT_TRUE(plan.has(index)) << plan.text;
  const std::size_t again = plan.text.find("foothold plan ");
  ASSERT_NE(again, std::string::npos) << plan.text;
  const std::string command = plan.text.substr(again, plan.text.find('\n', again) - again);
  for (const char* part : {"--seed 7", "--set steps=3", "--set pause_us=0"})
    EXPECT_NE(command.find(part), std::string::npos) << command;

  // That command gives the same steps.
  EXPECT_EQ(foothold(command.substr(std::string("foothold ").size()) + " -o " + at("again.json")).code, 0);
  auto before = client::read_plan_file(at("plan.json")), after = client::read_plan_file(at("again.json"));
  ASSERT_EQ(after.steps.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    after.steps[i].request(before.request.id());
    EXPECT_EQ(msg::encode(after.steps[i]), msg::encode(before.steps[i]));
  }
}

TEST_F(Commands, PlanAsJsonIsOneObjectALineAndTheFinalEventLast) {
  const Printed plan = foothold("--json plan " + request("walker") + " --set steps=2");
  EXPECT_EQ(plan.code, 0);
  std::istringstream lines(plan.text);
  std::vector<std::string> kinds;
  std::string line, last;
  while (std::getline(lines, line)) {
    kinds.push_back(line.substr(0, 9));
    last = line;
  }
  EXPECT_EQ(std::ranges::count(kinds, "{\"step\":{"), 2);
  EXPECT_NE(last.find("\"state\":\"SUCCEEDED\""), std::string::npos) << plan.text;
}

struct Ending {
  const char* robot;
  const char* arguments;
  int code;
  const char* says;
};

class Endings : public Commands, public testing::WithParamInterface<Ending> {};

TEST_P(Endings, HaveTheirExitCodeAndSayWhy) {
  const Printed plan = foothold("plan " + request(GetParam().robot) + " " + GetParam().arguments);
  EXPECT_EQ(plan.code, GetParam().code) << plan.text;
  EXPECT_TRUE(plan.has(GetParam().says)) << plan.text;
}

INSTANTIATE_TEST_SUITE_P(All, Endings,
                         testing::Values(Ending{"throw", "", 4, "PLUGIN_THREW"}, Ending{"crash", "", 7, "WORKER_CRASHED"},
                                         Ending{"heed", "--budget 0.3", 6, "BUDGET_EXHAUSTED"},
                                         Ending{"walker", "--set steps=-1", 8, "PARAMETER_OUT_OF_RANGE: parameters.steps"},
                                         Ending{"walker", "--set stesp=1", 8, "UNKNOWN_PARAMETER: parameters.stesp"},
                                         Ending{"nobody", "", 8, "UNKNOWN_ROBOT"},
                                         Ending{"walker", "--scene nowhere", 8, "UNKNOWN_SCENE"}));

TEST_F(Commands, CtrlCCancelsAndWaitsForTheEnd) {
  Program plan("cyclone", kDomain, "plan " + request("walker") + " --set steps=100000 --set pause_us=2000");
  ASSERT_TRUE(eventually([&] { return plan.has("\n   5  "); })) << plan.text();
  plan.signal(SIGINT);
  const Printed end = plan.finish();
  EXPECT_EQ(end.code, 5) << end.text;
  EXPECT_TRUE(end.has("cancelling") && end.has("CANCELLED  ") && end.has("CANCELLED_BY_CLIENT")) << end.text;
}

TEST_F(Commands, CancelAndStateKnowTheRequestsOfOthers) {
  Program plan("cyclone", kDomain, "plan " + request("walker") + " --set steps=100000 --set pause_us=2000");
  ASSERT_TRUE(eventually([&] { return plan.has("\n   5  "); })) << plan.text();
  const std::string id = id_in(plan.text());
  const Printed running = foothold("state " + id);
  EXPECT_EQ(running.code, 0);
  EXPECT_TRUE(running.has("RUNNING  ")) << running.text;
  const Printed cancelled = run("fastdds", kDomain, "cancel " + id + " --reason 'another robot needs the yard'");
  EXPECT_EQ(cancelled.code, 0) << cancelled.text;
  EXPECT_TRUE(cancelled.has("another robot needs the yard")) << cancelled.text;
  EXPECT_EQ(plan.finish().code, 5);
  const Printed ended = foothold("state " + id + " --steps");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(ended.has("\n   5  ") && ended.has("CANCELLED")) << ended.text;
  EXPECT_EQ(foothold("cancel " + id).code, 0);
}

TEST_F(Commands, AnUnknownIdIsSaidToBeUnknown) {
  const std::string id(32, '7');
  EXPECT_EQ(foothold("state " + id).code, 10);
  EXPECT_EQ(foothold("cancel " + id).code, 10);
  EXPECT_EQ(foothold("draw " + id + " -o " + at("x.svg")).code, 10);
}

TEST_F(Commands, ReplayComparesOctetForOctet) {
  ASSERT_EQ(foothold("plan " + request("walker") + " --set steps=4 -o " + at("plan.json")).code, 0);
  const Printed same = foothold("replay " + at("plan.json"));
  EXPECT_EQ(same.code, 0) << same.text;
  EXPECT_TRUE(same.has("the same plan: 4 steps, equal octet for octet")) << same.text;
  auto record = client::read_plan_file(at("plan.json"));
  record.steps[2].cost(record.steps[2].cost() + 1e-12);
  record.final_event.summary().plugin_version("0.9");
  client::write_plan_file(at("other.json"), record);
  const Printed other = foothold("replay " + at("other.json"));
  EXPECT_EQ(other.code, 11) << other.text;
  EXPECT_TRUE(other.has("step 2 is the first that differs") && other.has("0.9")) << other.text;
}

TEST_F(Commands, DrawTakesAFileOrAnId) {
  const Printed plan = foothold("plan " + request("walker") + " --set steps=4 --shapes -o " + at("plan.json"));
  ASSERT_EQ(plan.code, 0) << plan.text;
  EXPECT_EQ(foothold("draw " + at("plan.json") + " -o " + at("a.svg")).code, 0);
  EXPECT_EQ(foothold("draw " + id_in(plan.text) + " -o " + at("b.svg") + " --view above --steps 1-2").code, 0);
  for (const char* name : {"a.svg", "b.svg"}) {
    std::ifstream picture(at(name));
    const std::string text(std::istreambuf_iterator<char>(picture), {});
    EXPECT_NE(text.find("<svg"), std::string::npos) << name;
    EXPECT_NE(text.find("</svg>"), std::string::npos) << name;
  }
  EXPECT_EQ(foothold("draw " + at("plan.json") + " -o " + at("c.svg") + " --steps 9-10").code, 2);
}

TEST_F(Commands, ScenesAreStoredListedAndSentWithARequest) {
  const std::string scene = file("yard.yaml", "planes: []\n");
  const Printed put = foothold("scene put " + scene);
  EXPECT_EQ(put.code, 0) << put.text;
  EXPECT_TRUE(foothold("scene list").has("yard"));
  const Printed plan = foothold("plan " + request("walker", "scene: {file: yard.yaml, name: other}\n"));
  EXPECT_EQ(plan.code, 0) << plan.text;
  EXPECT_TRUE(plan.has("scene other stored") && plan.has("--scene other@")) << plan.text;
  const Printed refused = foothold("scene put " + file("bad.yaml", "a: [\n"));
  EXPECT_EQ(refused.code, 8);
  EXPECT_TRUE(refused.has("INVALID_SCENE") && refused.has("line 2")) << refused.text;
  EXPECT_EQ(foothold("scene put " + file("scene.dxf", "")).code, 2);
}

TEST_F(Commands, ASceneOfManyChunksArrivesWhole) {
  std::string text = "planes:\n";
  while (text.size() < 3'000'000) text += "  - {name: plane_" + std::to_string(text.size()) + "}\n";
  const std::string scene = file("large.yaml", text);
  for (const char* vendor : {"cyclone", "fastdds"}) {
    const Printed put = run(vendor, kDomain, "scene put " + scene);
    EXPECT_EQ(put.code, 0) << put.text;
    EXPECT_TRUE(put.has(msg::sha256_hex(text))) << put.text;
  }
}

TEST_F(Commands, DoctorFindsTheServerThroughBothVendors) {
  const Printed doctor = foothold("doctor");
  EXPECT_EQ(doctor.code, 0) << doctor.text;
  EXPECT_TRUE(doctor.has("ok    server by cyclone: test ") && doctor.has("ok    server by fastdds: test ")) << doctor.text;
}

TEST_F(Commands, PluginInfoTellsWhatAPluginHoldsOrWhyItIsRefused) {
  const std::string plugins = FOOTHOLD_TEST_PLUGINS "/";
  const Printed good = foothold("plugin info " + plugins + "many.so");
  EXPECT_EQ(good.code, 0) << good.text;
  EXPECT_TRUE(good.has("many") && good.has("pause_us")) << good.text;
  const Printed refused = foothold("plugin info " + plugins + "unlike_api.so");
  EXPECT_EQ(refused.code, 8);
  EXPECT_TRUE(refused.has("refused")) << refused.text;
  EXPECT_EQ(foothold("plugin info " + file("text.so", "no library")).code, 8);
}

TEST(NoServer, IsSaidWithWhatToDo) {
  const Printed plan = run("cyclone", kDomain + 1, "robots --timeout 0.5");
  EXPECT_EQ(plan.code, 9);
  EXPECT_TRUE(plan.has("no server answered within 500.0 ms") && plan.has("foothold doctor")) << plan.text;
}

TEST(LostServer, IsWaitedForAndItsPlansEndIsTold) {
  Daemon daemon({.domain = kDomain, .robots = {good_robot("walker")}});
  const std::string request = testing::TempDir() + "foothold_lost.yaml";
  std::ofstream(request) << "robot: walker\ngoal: {base: {position: [1, 0, 0], heading_deg: 0}}\nbudget: 50\n";
  Program plan("cyclone", kDomain, "plan " + request + " --set steps=100000 --set pause_us=2000");
  ASSERT_TRUE(eventually([&] { return plan.has("\n   5  "); })) << plan.text();
  daemon.kill();
  ASSERT_TRUE(eventually([&] { return plan.has("the server is silent; waiting for it"); }));
  daemon.start();
  const Printed end = plan.finish();
  EXPECT_EQ(end.code, 4) << end.text;
  EXPECT_TRUE(end.has("the server is back") && end.has("SERVER_RESTARTED"));
  EXPECT_EQ(daemon.stop(), 0);
  std::filesystem::remove(request);
}

}  // namespace
}  // namespace foothold::test
