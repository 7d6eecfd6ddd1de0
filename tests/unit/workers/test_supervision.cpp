// Starting, starting again, quarantine, reload; and that nothing is left behind.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>

#include "fixture.hpp"

namespace foothold::server::test {
namespace {

using namespace std::chrono_literals;

WorkersConfig quick_limits() {
  WorkersConfig limits;
  limits.restart_first = 0.02;
  limits.quarantine_time = 0.5;
  return limits;
}

Quantity number(double value, const char* unit) { return {.values = {value}, .unit = unit, .source = "assumed: by the test"}; }

RobotConfig robot_with_model(std::map<std::string, Quantity, std::less<>> model) {
  RobotConfig robot = Rig::robot("model");
  robot.model = RobotModel(std::move(model));
  return robot;
}

std::string reason_of(RobotConfig robot, const WorkersConfig& limits = quick_limits()) {
  Rig rig;
  const std::string name = robot.name;
  rig.open({std::move(robot)}, limits);
  const RobotStatus status = rig.workers->status(name);
  EXPECT_EQ(status.info->state(), msg::UNAVAILABLE);
  EXPECT_FALSE(rig.workers->has_idle(name));
  return status.info->reason();
}

void expect_words(const std::string& sentence, std::initializer_list<std::string> words) {
  for (const std::string& word : words) EXPECT_NE(sentence.find(word), std::string::npos) << "'" << word << "' in: " << sentence;
}

std::size_t open_descriptors() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

TEST(Supervision, AModelThatFitsReachesTheConstructor) {
  Rig rig;
  rig.open({robot_with_model({{"body.length", number(0.1, "m")}})});
  EXPECT_TRUE(rig.workers->has_idle("model")) << rig.workers->status("model").info->reason();
}

TEST(Supervision, ARobotWhoseModelDoesNotFitIsUnavailableWithThePath) {
  expect_words(reason_of(robot_with_model({})), {"model.body.length", "is missing"});
  expect_words(reason_of(robot_with_model({{"body.length", number(0.1, "rad")}})),
               {"model.body.length", "must be in m, is in rad"});
}

TEST(Supervision, EveryPluginThatCannotBeUsedIsUnavailableWithItsReason) {
  expect_words(reason_of(Rig::robot("unlike_api")), {"API version"});
  expect_words(reason_of(Rig::robot("no_entry")), {"FOOTHOLD_EXPORT_PLANNER"});
  expect_words(reason_of(Rig::robot("not_there")), {"not_there.so", "No such file"});
  expect_words(reason_of(Rig::robot("schema_default")), {"'gait'", "is 11"});
  expect_words(reason_of(Rig::robot("schema_twice")), {"'gait' twice"});
  expect_words(reason_of(Rig::robot("schema_bounds")), {"'gait'", "minimum above its maximum"});
  expect_words(reason_of(robot_with_model({{"throws", number(1, "1")}})), {"the constructor's words"});
  expect_words(reason_of(robot_with_model({{"throws_int", number(1, "1")}})), {"no std::exception"});
}

TEST(Supervision, AWorkerProgramThatIsNotThereIsTold) {
  Rig rig;
  rig.program = "/nowhere/foothold-worker";
  rig.open({Rig::robot("many")}, quick_limits());
  expect_words(rig.workers->status("many").info->reason(), {"cannot be started", "/nowhere/foothold-worker"});
}

TEST(Supervision, AConstructorThatHangsOrDiesHoldsUpNoOtherRobot) {
  WorkersConfig limits = quick_limits();
  limits.start_limit = 0.3;
  RobotConfig hangs = robot_with_model({{"hangs", number(1, "1")}}), dies = robot_with_model({{"dies", number(1, "1")}});
  hangs.name = "hangs";
  dies.name = "dies";
  Rig rig;
  rig.open({hangs, dies, Rig::robot("many")}, limits);
  EXPECT_EQ(rig.plan(Rig::request("many")).ends[0].state, msg::SUCCEEDED);
  expect_words(rig.workers->status("hangs").info->reason(), {"was not ready within 300 ms"});
  rig.run_until([&] { return rig.workers->status("dies").info->state() == msg::QUARANTINED; });
  EXPECT_GT(rig.workers->status("dies").retry_after, 0.0);
}

TEST(Supervision, AWorkerThatDiedIsStartedAgainAndTheRobotStaysReady) {
  Rig rig;
  rig.open({Rig::robot("crash")}, quick_limits());
  rig.plan(Rig::request("crash"));
  EXPECT_FALSE(rig.workers->has_idle("crash"));
  EXPECT_EQ(rig.workers->status("crash").info->state(), msg::READY) << "its requests wait";
  rig.run_until([&] { return rig.workers->has_idle("crash"); });
  EXPECT_EQ(rig.plan(Rig::request("crash", {{"how", "not"}})).ends[0].state, msg::SUCCEEDED);
}

TEST(Supervision, AnIdleWorkerThatDiesIsStartedAgain) {
  Rig rig;
  rig.open({Rig::robot("many")}, quick_limits());
  const pid_t pid = rig.workers->pids("many").at(0);
  ::kill(pid, SIGKILL);
  rig.run_until([&] {
    const auto pids = rig.workers->pids("many");
    return rig.workers->has_idle("many") && pids.at(0) != pid;
  });
  EXPECT_TRUE(rig.heard.empty());
}

TEST(Supervision, RepeatedCrashesQuarantineTheRobotAndATrialLetsItBack) {
  Rig rig;
  rig.open({Rig::robot("crash", 2)}, quick_limits());
  for (int crash = 0; crash < 3; ++crash) {
    rig.run_until([&] { return rig.workers->has_idle("crash"); });
    rig.plan(Rig::request("crash"));
  }
  const RobotStatus status = rig.workers->status("crash");
  EXPECT_EQ(status.info->state(), msg::QUARANTINED);
  EXPECT_GT(status.retry_after, 0.0);
  EXPECT_LE(status.retry_after, 0.5);
  expect_words(status.info->reason(), {"3 crashes"});
  EXPECT_FALSE(rig.workers->has_idle("crash"));

  // On trial: one worker of two slots; its crash takes the robot out at once.
  rig.run_until([&] { return rig.workers->has_idle("crash"); });
  EXPECT_EQ(rig.workers->status("crash").info->state(), msg::READY);
  rig.run_for(100ms);
  EXPECT_EQ(rig.workers->pids("crash").size(), 1u);
  rig.plan(Rig::request("crash"));
  EXPECT_EQ(rig.workers->status("crash").info->state(), msg::QUARANTINED);

  rig.run_until([&] { return rig.workers->has_idle("crash"); });
  EXPECT_EQ(rig.plan(Rig::request("crash", {{"how", "not"}})).ends[0].state, msg::SUCCEEDED);
  rig.run_until([&] { return rig.workers->pids("crash").size() == 2u; });
  rig.plan(Rig::request("crash"));
  EXPECT_EQ(rig.workers->status("crash").info->state(), msg::READY) << "a trial that was passed forgives";
}

TEST(Supervision, ARunThatGoesOnWhenItsRobotIsQuarantinedEndsByItself) {
  Rig rig;
  WorkersConfig limits = quick_limits();
  limits.quarantine_crashes = 1;
  rig.open({Rig::robot("crash", 2)}, limits);
  const auto lost = rig.start(Rig::request("crash"));
  const auto kept = rig.start(Rig::request("crash", {{"how", "not"}}));
  rig.end_of(lost);
  EXPECT_EQ(rig.end_of(kept).ends[0].state, msg::SUCCEEDED);
}

TEST(Supervision, KillsByTheDaemonAreNoCrashes) {
  Rig rig;
  rig.open({Rig::robot("hang")}, quick_limits());
  for (int i = 0; i < 5; ++i) {
    rig.run_until([&] { return rig.workers->has_idle("hang"); });
    const auto run = rig.start(Rig::request("hang"));
    rig.workers->kill(run, "by the test");
    EXPECT_EQ(rig.end_of(run).ends[0].error.code(), msg::WORKER_KILLED);
  }
  EXPECT_EQ(rig.workers->status("hang").info->state(), msg::READY);
}

TEST(Supervision, AReloadBringsANewWorkerAndARunGoesOn) {
  Rig rig;
  rig.open({Rig::robot("many")}, quick_limits());
  const auto before = rig.workers->pids("many");
  const auto run = rig.start(Rig::request("many", {{"steps", "400"}, {"pause_us", "1000"}}));
  EXPECT_TRUE(rig.workers->reload("many"));
  rig.run_until([&] { return rig.workers->has_idle("many"); });
  EXPECT_TRUE(rig.heard[run].ends.empty()) << "the older worker was to go on";
  EXPECT_EQ(rig.end_of(run).ends[0].state, msg::SUCCEEDED);
  rig.run_until([&] { return rig.workers->pids("many").size() == 1u; });
  EXPECT_NE(rig.workers->pids("many"), before);
  EXPECT_EQ(rig.plan(Rig::request("many")).ends[0].state, msg::SUCCEEDED);
}

TEST(Supervision, AReloadThatIsRefusedKeepsTheOlderWorkers) {
  const auto directory = std::filesystem::temp_directory_path() / ("foothold_reload_" + std::to_string(getpid()));
  std::filesystem::create_directory(directory);
  const auto install = [&](const std::string& name) {
    // As a package does it: the file that runs is not written to.
    std::filesystem::copy_file(std::string(FOOTHOLD_TEST_PLUGINS) + "/" + name + ".so", directory / "new.so");
    std::filesystem::rename(directory / "new.so", directory / "planner.so");
  };
  install("many");
  RobotConfig robot = Rig::robot("many", 2);
  robot.plugin = directory / "planner.so";
  {
    Rig rig;
    rig.open({robot}, quick_limits());
    rig.run_until([&] { return rig.workers->pids("many").size() == 2u; });
    const auto before = rig.workers->pids("many");
    install("unlike_api");
    rig.workers->reload("many");
    rig.run_until([&] { return rig.workers->pids("many").size() > 2u; });
    rig.run_until([&] { return rig.workers->pids("many").size() == 2u; });
    EXPECT_EQ(rig.workers->pids("many"), before);
    EXPECT_EQ(rig.plan(Rig::request("many")).ends[0].state, msg::SUCCEEDED);

    install("recall");
    rig.workers->reload("many");
    rig.run_until([&] { return rig.workers->status("many").info->plugin() == "recall"; });
    rig.run_until([&] { return rig.workers->pids("many").size() == 2u; });
    EXPECT_NE(rig.workers->pids("many"), before);
  }
  std::filesystem::remove_all(directory);
}

TEST(Supervision, TwoHundredCrashesLeaveNoDescriptorAndNoZombie) {
  Rig rig;
  WorkersConfig limits = quick_limits();
  limits.restart_first = 0.001;
  limits.restart_longest = 0.001;
  limits.quarantine_crashes = 100000;
  rig.open({Rig::robot("crash", 4)}, limits);
  const auto crash_once = [&] {
    rig.run_until([&] { return rig.workers->has_idle("crash"); });
    rig.plan(Rig::request("crash", {{"at", "1"}}));
  };
  for (int i = 0; i < 5; ++i) crash_once();
  const auto all_idle = [&] { return rig.workers->pids("crash").size() == 4 && rig.workers->has_idle("crash"); };
  rig.run_until(all_idle);
  const std::size_t before = open_descriptors();
  for (int i = 0; i < 200; ++i) crash_once();
  rig.run_until(all_idle);
  EXPECT_EQ(open_descriptors(), before);
  rig.workers.reset();
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
  EXPECT_EQ(errno, ECHILD);
}

TEST(Supervision, AWorkerInheritsNothingButItsOwnDescriptors) {
  const int secret = open("/etc/hostname", O_RDONLY);  // without O_CLOEXEC, as libraries do
  Rig rig;
  rig.open({Rig::robot("many")}, quick_limits());
  for (const auto& entry : std::filesystem::directory_iterator("/proc/" + std::to_string(rig.workers->pids("many").at(0)) + "/fd"))
    EXPECT_NE(std::filesystem::read_symlink(entry.path()), "/etc/hostname") << entry.path();
  close(secret);
}

}  // namespace
}  // namespace foothold::server::test
