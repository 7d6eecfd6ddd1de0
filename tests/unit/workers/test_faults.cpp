// Each planner that misbehaves ends its own run with the right typed error, in time; another robot's run, going on at the same
// time, is not disturbed, and neither is this process.
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "fixture.hpp"

namespace foothold::server::test {
namespace {

using namespace std::chrono_literals;

constexpr auto kGrace = 200ms;
// Processes are started and killed on a machine that is busy with something else.
constexpr auto kSlack = 3s;

void expect_words(const std::string& sentence, std::initializer_list<std::string> words) {
  for (const std::string& word : words) EXPECT_NE(sentence.find(word), std::string::npos) << "'" << word << "' in: " << sentence;
}

// A robot that is asked to misbehave beside one that walks on.
class Beside {
 public:
  explicit Beside(RobotConfig bad) {
    const std::string name = bad.name;
    rig.open({std::move(bad), Rig::robot("many")});
    if (!rig.workers->has_idle(name)) ADD_FAILURE() << name << " is not ready: " << rig.workers->status(name).info->reason();
    good_ = rig.start(Rig::request("many", {{"steps", "100000"}, {"pause_us", "1000"}}));
    rig.run_until([&] { return rig.heard[good_].steps.size() > 5; });
  }
  explicit Beside(const std::string& bad) : Beside(Rig::robot(bad)) {}

  // Plays the daemon: after `budget` it stops the run, after the grace time it kills.
  const Heard& plan(const msg::PlanRequest& request, std::chrono::milliseconds budget = 10s) {
    const auto run = rig.start(request);
    const auto ended = [&] { return !rig.heard[run].ends.empty(); };
    const auto wait = [&](std::chrono::milliseconds time) {
      const auto end = std::chrono::steady_clock::now() + time;
      rig.run_until([&] { return ended() || std::chrono::steady_clock::now() >= end; });
    };
    wait(budget);
    if (!ended()) {
      rig.workers->stop(run);
      wait(kGrace);
    }
    if (!ended()) rig.workers->kill(run, "did not stop within 200 ms");
    rig.run_until(ended);
    const Heard& heard = rig.heard[run];
    EXPECT_LT(heard.ended - heard.started, budget + kGrace + kSlack);
    return heard;
  }

  // The good run goes on, and ends as it should.
  ~Beside() {
    const std::size_t before = rig.heard[good_].steps.size();
    rig.run_until([&] { return rig.heard[good_].steps.size() > before + 20; });
    EXPECT_TRUE(rig.heard[good_].ends.empty());
    rig.workers->stop(good_);
    EXPECT_EQ(rig.end_of(good_).ends[0].state, msg::CANCELLED);
    EXPECT_EQ(getpid(), pid_);
  }

  Rig rig;

 private:
  pid_t pid_ = getpid();
  Run good_ = 0;
};

TEST(Faults, ACrashTellsTheSignalAndTheLastWords) {
  Beside beside("crash");
  const Heard& heard = beside.plan(Rig::request("crash"));
  EXPECT_EQ(heard.ends[0].kind, RunEnd::Kind::kLost);
  EXPECT_EQ(heard.ends[0].error.code(), msg::WORKER_CRASHED);
#ifdef FOOTHOLD_SANITIZED
  expect_words(heard.ends[0].error.message(), {"crash"});
#else
  expect_words(heard.ends[0].error.message(), {"died of SIGSEGV", "signal SIGSEGV at address 0x0", "crash.so"});
#endif
  EXPECT_EQ(heard.steps.size(), 3u) << "what was sent before the crash stays";
}

#ifndef FOOTHOLD_SANITIZED
TEST(Faults, AnAbortAnExitAndAKillAreToldApart) {
  Beside beside("crash");
  const auto message_of = [&](const char* how) {
    beside.rig.run_until([&] { return beside.rig.workers->has_idle("crash"); });
    const RunEnd& end = beside.plan(Rig::request("crash", {{"how", how}, {"at", "0"}})).ends[0];
    EXPECT_EQ(end.error.code(), msg::WORKER_CRASHED);
    return end.error.message();
  };
  expect_words(message_of("abort"), {"died of SIGABRT", "signal SIGABRT"});
  expect_words(message_of("exit"), {"exited with code 7"});
}

TEST(Faults, AKillFromOutsideIsToldAsSuch) {
  Beside beside("crash");
  expect_words(beside.plan(Rig::request("crash", {{"how", "kill"}})).ends[0].error.message(),
               {"died of SIGKILL, which footholdd did not send"});
}
#endif

TEST(Faults, AHangIsKilledAfterItsGrace) {
  Beside beside("hang");
  for (const char* in : {"plan", "prepare"}) {
    beside.rig.run_until([&] { return beside.rig.workers->has_idle("hang"); });
    const Heard& heard = beside.plan(Rig::request("hang", {{"in", in}}), 100ms);
    EXPECT_EQ(heard.ends[0].kind, RunEnd::Kind::kLost);
    EXPECT_EQ(heard.ends[0].error.code(), msg::WORKER_KILLED);
    EXPECT_EQ(heard.ends[0].error.message(), "did not stop within 200 ms");
    EXPECT_GE(heard.ended - heard.started, 100ms + kGrace);
  }
}

TEST(Faults, APlannerThatIgnoresItsTokenIsKilledAfterItsGrace) {
  Beside beside("ignore");
  const Heard& heard = beside.plan(Rig::request("ignore"), 100ms);
  EXPECT_EQ(heard.ends[0].error.code(), msg::WORKER_KILLED);
  EXPECT_EQ(heard.steps.size(), 1u);
}

TEST(Faults, APlannerThatHeedsItsTokenKeepsItsWorker) {
  Beside beside("heed");
  const auto before = beside.rig.workers->pids("heed");
  const Heard& heard = beside.plan(Rig::request("heed"), 100ms);
  EXPECT_EQ(heard.ends[0].kind, RunEnd::Kind::kReport);
  EXPECT_EQ(heard.ends[0].state, msg::CANCELLED);
  EXPECT_EQ(beside.rig.workers->pids("heed"), before);
}

TEST(Faults, MemoryThatRunsOutEndsTheRunAndTheWorkerIsReplaced) {
  RobotConfig robot = Rig::robot("memory");
  robot.memory_limit = 512u << 20;
  Beside beside(robot);
  for (const char* in : {"pieces", "crumbs"}) {
    beside.rig.run_until([&] { return beside.rig.workers->has_idle("memory"); });
    const auto before = beside.rig.workers->pids("memory");
    const Heard& heard = beside.plan(Rig::request("memory", {{"in", in}}));
    EXPECT_EQ(heard.ends[0].kind, RunEnd::Kind::kLost);
    EXPECT_EQ(heard.ends[0].error.code(), msg::OUT_OF_MEMORY) << in << ": " << heard.ends[0].error.message();
    EXPECT_EQ(heard.steps.size(), 1u);
    beside.rig.run_until([&] { return beside.rig.workers->has_idle("memory"); });
    EXPECT_NE(beside.rig.workers->pids("memory"), before);
  }
}

TEST(Faults, ExceptionsEndTheRunWithTheirWordsAndWhereTheyCameFrom) {
  Beside beside("throw");
  struct Thrown {
    const char *in, *what;
    std::uint16_t code;
    const char* words;
  };
  const Thrown all[] = {{"plan", "std", msg::PLUGIN_THREW, "plan() threw: the thrown words"},
                        {"prepare", "std", msg::PLUGIN_THREW, "prepare() threw: the thrown words"},
                        {"start", "std", msg::PLUGIN_THREW, "start() threw: the thrown words"},
                        {"check", "std", msg::PLUGIN_THREW, "step 0: check() threw: the thrown words"},
                        {"plan", "int", msg::PLUGIN_THREW, "no std::exception"},
                        {"check", "int", msg::PLUGIN_THREW, "no std::exception"},
                        {"prepare", "scene", msg::INVALID_SCENE, "must be above 0"},
                        {"start", "request", msg::INVALID_GOAL, "cannot be planned for"},
                        {"nowhere", "std", msg::NO_ERROR, ""}};
  const auto pids = beside.rig.workers->pids("throw");
  for (const Thrown& thrown : all) {
    const RunEnd& end = beside.plan(Rig::request("throw", {{"in", thrown.in}, {"what", thrown.what}})).ends[0];
    EXPECT_EQ(end.kind, RunEnd::Kind::kReport);
    EXPECT_EQ(end.error.code(), thrown.code) << thrown.in << " " << thrown.what << ": " << end.error.message();
    expect_words(end.error.message(), {thrown.words});
  }
  EXPECT_EQ(beside.rig.workers->pids("throw"), pids) << "an exception costs no worker";
}

TEST(Faults, AnInvalidRequestNamesStartGoalOrTheField) {
  Beside beside("throw");
  const std::pair<const char*, std::uint16_t> fields[] = {
      {"goal.base.position", msg::INVALID_GOAL}, {"start.contacts[1]", msg::INVALID_START}, {"parameters.gait", msg::MALFORMED}};
  for (const auto& [field, code] : fields) {
    const RunEnd& end = beside.plan(Rig::request("throw", {{"what", "request"}, {"field", field}})).ends[0];
    EXPECT_EQ(end.state, msg::FAILED);
    EXPECT_EQ(end.error.code(), code);
    EXPECT_EQ(end.error.field(), field);
  }
}

TEST(Faults, AnInvalidSceneNamesTheField) {
  Beside beside("throw");
  const RunEnd& end = beside.plan(Rig::request("throw", {{"in", "prepare"}, {"what", "scene"}})).ends[0];
  EXPECT_EQ(end.error.field(), "beams[2].length");
}

TEST(Faults, BadAllocIsToldAsMemoryThatRanOut) {
  for (const char* in : {"plan", "prepare", "check"}) {
    Beside beside("throw");
    const RunEnd& end = beside.plan(Rig::request("throw", {{"in", in}, {"what", "bad_alloc"}})).ends[0];
    EXPECT_EQ(end.kind, RunEnd::Kind::kLost);
    EXPECT_EQ(end.error.code(), msg::OUT_OF_MEMORY);
    expect_words(end.error.message(), {in});
    beside.rig.run_until([&] { return beside.rig.workers->has_idle("throw"); });
  }
}

TEST(Faults, AStepThatIsNotFitToBeSentEndsTheRunBeforeIt) {
  Beside beside("refused");
  struct Bad {
    const char* how;
    std::uint16_t code;
    const char* words;
  };
  const Bad all[] = {{"too_far", msg::STEP_REFUSED, "step 4: the body moves 0.6"},
                     {"nan_joint", msg::STEP_REFUSED, "step 4: joints hold a number that is not finite"},
                     {"no_rotation", msg::STEP_REFUSED, "step 4: stance[1].frame is not a rotation"},
                     {"nan_cost", msg::STEP_REFUSED, "step 4: cost is not finite"},
                     {"margin", msg::STEP_REFUSED, "margin 'balance' is 0.01"},
                     {"label", msg::STEP_REFUSED, "step 4: label must be UTF-8 without control characters, is 'a\\x00b'"},
                     {"huge", msg::OVERSIZE, "step 4: takes more than 16 MiB"}};
  for (const Bad& bad : all) {
    const Heard& heard = beside.plan(Rig::request("refused", {{"how", bad.how}}));
    EXPECT_EQ(heard.ends[0].state, msg::FAILED);
    EXPECT_EQ(heard.ends[0].error.code(), bad.code) << bad.how;
    expect_words(heard.ends[0].error.message(), {bad.words});
    EXPECT_EQ(heard.steps.size(), 4u) << "neither the bad step nor those after it are sent";
    EXPECT_EQ(heard.ends[0].summary.steps(), 4u);
  }
}

TEST(Faults, AReportThatContradictsItselfIsNotPassedOn) {
  Beside beside("lying");
  for (const char* about : {"optimal", "bound", "nan", "stopped", "silent", "number"}) {
    const RunEnd& end = beside.plan(Rig::request("lying", {{"about", about}})).ends[0];
    EXPECT_EQ(end.state, msg::FAILED) << about;
    EXPECT_EQ(end.error.code(), msg::WORKER_PROTOCOL) << about;
    EXPECT_EQ(end.summary.steps(), 1u);
  }
}

TEST(Faults, AWorkerThatSpeaksNonsenseIsKilled) {
  const std::pair<const char*, const char*> lies[] = {{"kind", "unknown kind 77"},
                                                      {"length", "STEP frame of 4294967295 octets"},
                                                      {"run", "STEP frame of run 999"},
                                                      {"request", "a step of request 0909"},
                                                      {"index", "step 5 where step 0 was due"},
                                                      {"no_step", "payload is no step"},
                                                      {"report", "REPORT frame whose payload cannot be read"},
                                                      {"ready", "a second READY frame"},
                                                      {"plan", "which only the daemon sends"},
                                                      {"noise", "unknown kind"},
                                                      {"close", "closed its channel"}};
  for (const auto& [how, words] : lies) {
    Rig rig;
    rig.open({Rig::robot("impostor")});
    msg::PlanRequest request = Rig::request("impostor", {{"how", how}});
    request.id().fill(7);
    const Heard& heard = rig.plan(request);
    EXPECT_EQ(heard.ends[0].kind, RunEnd::Kind::kLost) << how;
    EXPECT_EQ(heard.ends[0].error.code(), msg::WORKER_PROTOCOL) << how << ": " << heard.ends[0].error.message();
    expect_words(heard.ends[0].error.message(), {words});
    EXPECT_TRUE(heard.steps.empty());
    rig.run_until([&] { return rig.workers->has_idle("impostor"); });
  }
}

TEST(Faults, TheLastWordsOfAChatterboxAreItsLast) {
  Beside beside("chatter");
  const RunEnd& end = beside.plan(Rig::request("chatter")).ends[0];
  EXPECT_EQ(end.error.code(), msg::WORKER_CRASHED);
  expect_words(end.error.message(), {"exited with code 3", "line 19998", "a cry from the end"});
  EXPECT_EQ(end.error.message().find("line 100 "), std::string::npos);
  EXPECT_LT(end.error.message().size(), 8000u);
}

bool lives(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/stat");
  std::string number, name, state;
  return static_cast<bool>(status >> number >> name >> state) && state != "Z";
}

TEST(Faults, WhatAPlannerStartedIsKilledWithIt) {
  Beside beside("chatter");
  const Heard& heard = beside.plan(Rig::request("chatter", {{"how", "child"}}), 100ms);
  EXPECT_EQ(heard.ends[0].error.code(), msg::WORKER_KILLED);
  const pid_t child = std::stoi(heard.steps.at(0).attributes().at(0).value());
  beside.rig.run_until([&] { return !lives(child); });
}

}  // namespace
}  // namespace foothold::server::test
