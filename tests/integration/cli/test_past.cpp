// history, replay and top against the real daemon, while it runs and after it died.
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <regex>

#include "daemon.hpp"
#include "eventually.hpp"
#include "planners.hpp"
#include "program.hpp"

namespace foothold::test {
namespace {

constexpr unsigned kDomain = 79;

class Past : public testing::Test {
 protected:
  Past()
      : daemon_({.domain = kDomain,
                 .robots = {good_robot("walker", 2), bad_robot("crash"), bad_robot("heed")},
                 .more = kNeverQuarantine}) {}

  Printed foothold(const std::string& arguments) { return run("cyclone", kDomain, arguments); }
  Printed with_state(const std::string& arguments) { return foothold(arguments + " --state-dir " + daemon_.state_folder()); }
  // Plans and gives the id.
  std::string plan(const std::string& robot, const std::string& more = "") {
    const std::string file = folder_ / "request.yaml";
    std::ofstream(file) << "robot: " << robot << "\nunit: yard-3\ngoal: {base: {position: [1, 0, 0], heading_deg: 0}}\nbudget: 20\n"
                        << more;
    const Printed printed = foothold("--timeout 20 plan " + file + " -o " + (folder_ / "plan.json"));
    std::smatch match;
    std::ifstream in(folder_ / "plan.json");
    const std::string json((std::istreambuf_iterator<char>(in)), {});
    EXPECT_TRUE(std::regex_search(json, match, std::regex("[0-9a-f]{32}"))) << printed.text;
    return match.str();
  }
  TemporaryFolder folder_;
  Daemon daemon_;
};

TEST_F(Past, HistoryHoldsWhatHappenedWhetherTheServerRunsOrNot) {
  const std::string done = plan("walker", "parameters: {steps: 3}\n");
  const std::string crashed = plan("crash");
  const std::string last = plan("walker");
  const auto check = [&] {
    const Printed all = with_state("history");
    EXPECT_EQ(all.code, 0) << all.text;
    const auto at = [&](const std::string& words) { return all.text.find(words); };
    EXPECT_LT(at(last), at(crashed)) << all.text;
    EXPECT_LT(at(crashed), at(done)) << all.text;
    EXPECT_NE(at("WORKER_CRASHED"), std::string::npos) << all.text;
    EXPECT_NE(at("yard-3"), std::string::npos) << all.text;
    EXPECT_FALSE(with_state("history --state CRASHED").has(done));
    EXPECT_TRUE(with_state("history --state CRASHED").has(crashed));
    EXPECT_FALSE(with_state("history --robot crash").has(done));
    EXPECT_FALSE(with_state("history -n 1").has(done));
    EXPECT_TRUE(with_state("history --unit yard-3 --since 600").has(done));
    EXPECT_FALSE(with_state("history --unit another").has(done));
    const Printed one = with_state("history " + done);
    EXPECT_TRUE(one.has("SUCCEEDED") && one.has("3 steps") && one.has("unit yard-3")) << one.text;
    const Printed json = with_state("--json history " + done);
    EXPECT_TRUE(json.has("{\"request\":{\"id\":\"" + done)) << json.text;
  };
  check();
  daemon_.kill();
  check();
  daemon_.start();
  check();
}

TEST_F(Past, WhatRunsIsUnfinished) {
  const std::string file = folder_ / "long.yaml";
  std::ofstream(file) << "robot: walker\ngoal: {base: {position: [1, 0, 0], heading_deg: 0}}\nbudget: 60\nparameters: {steps: "
                         "100000, pause_us: 2000}\n";
  Program program("cyclone", kDomain, "--timeout 20 plan " + file);
  ASSERT_TRUE(eventually([&] { return with_state("history --state UNFINISHED").has("walker"); }));
  const Printed top = foothold("top --count 1 --timeout 20");
  EXPECT_EQ(top.code, 0) << top.text;
  EXPECT_TRUE(top.has("RUNNING") && top.has("serves")) << top.text;
  const Printed json = foothold("--json --timeout 20 top --count 2 --interval 0.1");
  EXPECT_EQ(std::count(json.text.begin(), json.text.end(), '\n'), 2) << json.text;
  EXPECT_TRUE(json.has("\"requests\":[{\"id\"") && json.has("\"robot\":\"walker\"") && json.has("\"state\":\"RUNNING\""))
      << json.text;
  program.signal(SIGINT);
  EXPECT_EQ(program.finish().code, 5);
}

TEST_F(Past, AReplayByIdGivesTheSameOctetsOrSaysWhatIsOther) {
  const std::string id = plan("walker", "parameters: {steps: 4}\n");
  const Printed same = with_state("replay " + id);
  EXPECT_EQ(same.code, 0) << same.text;
  EXPECT_TRUE(same.has("the same plan: 4 steps, equal octet for octet")) << same.text;
  const Printed crash = with_state("replay " + plan("crash"));
  EXPECT_EQ(crash.code, 7) << "it crashes again: " << crash.text;

  DaemonOptions options = daemon_.options();
  options.robots = {{.name = "walker", .plugin = "recall"}};
  ASSERT_EQ(daemon_.stop(), 0);
  daemon_.configure(options);
  daemon_.start();
  const Printed other = with_state("--timeout 20 replay " + id);
  EXPECT_EQ(other.code, 11) << other.text;
  EXPECT_TRUE(other.has("another plan")) << other.text;
  EXPECT_TRUE(other.has("planner") && other.has("many") && other.has("recall")) << other.text;
}

TEST_F(Past, ACrashAndASlowPlanLeaveBundlesThatCanBeReplayed) {
  namespace fs = std::filesystem;
  const auto only = [&](const std::string& kind) {
    const fs::path folder = fs::path(daemon_.state_folder()) / "bundles" / kind;
    std::vector<fs::path> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
      if (entry.path().extension() != ".part") found.push_back(entry.path());
    return found.size() == 1 ? found[0].string() : std::string();
  };
  const auto report = [](const std::string& folder) {
    std::ifstream in(folder + "/report.txt");
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string crashed = plan("crash", "parameters: {at: 2}\n");
  ASSERT_TRUE(eventually([&] { return !only("crashed").empty(); })) << daemon_.log();
  const std::string text = report(only("crashed"));
  std::vector<std::string> pieces{"request: " + crashed, "robot: crash", "unit: yard-3"};
#ifndef FOOTHOLD_SANITIZED  // the sanitizers catch the signal themselves
  pieces.insert(pieces.end(), {"signal: SIGSEGV", "signal SIGSEGV at address", "crash.so"});
#endif
  for (const std::string& piece : pieces) EXPECT_NE(text.find(piece), std::string::npos) << piece << " is not in:\n" << text;
  EXPECT_EQ(foothold("replay " + only("crashed")).code, 7);

  DaemonOptions options = daemon_.options();
  options.more += "bundles: {slow: 0.05}\n";
  daemon_.configure(options);
  daemon_.hang_up();
  ASSERT_TRUE(eventually([&] { return daemon_.log().find("the configuration is taken") != std::string::npos; }));
  plan("walker", "parameters: {steps: 5, pause_us: 20000}\n");
  ASSERT_TRUE(eventually([&] { return !only("slow").empty(); })) << daemon_.log();
  const std::string slow = only("slow");
  EXPECT_NE(report(slow).find("robot walker: worker "), std::string::npos) << "the log's tail: " << report(slow);
  const Printed same = foothold("replay " + slow);
  EXPECT_EQ(same.code, 0) << same.text;
  EXPECT_TRUE(same.has("the same plan: 5 steps, equal octet for octet")) << same.text;
  std::ofstream(slow + "/plan.entries") << "nonsense";
  const Printed spoilt = foothold("replay " + slow);
  EXPECT_EQ(spoilt.code, 2) << spoilt.text;
}

TEST_F(Past, WhatIsNotThereIsSaid) {
  ASSERT_EQ(foothold("--timeout 20 robots").code, 0) << "a server that is about to start has no journal yet";
  EXPECT_EQ(foothold("history --state-dir /nowhere").code, 2);
  EXPECT_TRUE(foothold("history --state-dir /nowhere").has("/nowhere/journal.db: cannot be read: No such file or directory"));
  EXPECT_EQ(with_state("history 0123456789abcdef0123456789abcdef").code, 10);
  EXPECT_EQ(with_state("replay 0123456789abcdef0123456789abcdef").code, 10);
  EXPECT_TRUE(with_state("history --state CRASHD").has("did you mean 'CRASHED'?"));
  EXPECT_EQ(run("cyclone", kDomain + 1, "--timeout 0.5 top --count 1").code, 9);
}

TEST_F(Past, TopEndsOnCtrlC) {
  Program top("cyclone", kDomain, "--timeout 20 top --interval 0.1");
  ASSERT_TRUE(eventually([&] { return top.has("serves"); }));
  top.signal(SIGINT);
  EXPECT_EQ(top.finish().code, 0);
}

}  // namespace
}  // namespace foothold::test
