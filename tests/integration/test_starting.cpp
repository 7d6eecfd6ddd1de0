// How footholdd starts, and how it says that it cannot: exit codes and sentences.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "child.hpp"
#include "daemon.hpp"
#include "planners.hpp"
#include "temporary_folder.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {
namespace fs = std::filesystem;

class Starting : public testing::Test {
 protected:
  Starting() {
    fs::create_directories(folder_ / "robots");
    write("robots/r.yaml", "robot: r\nplugin: many\n");
    write("footholdd.yaml", "robots_dir: robots\nstate_dir: state\n");
  }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  std::string log() const {
    std::ifstream in(folder_ / "log");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  std::optional<int> run(std::vector<std::string> words) {
    words.insert(words.begin(), {FOOTHOLD_DAEMON, "--config", folder_ / "footholdd.yaml"});
    Child child(words, folder_ / "log");
    return child.wait(20.0);
  }
  TemporaryFolder folder_;
};

TEST_F(Starting, CheckFindsNoFaultAndStartsNothing) {
  EXPECT_EQ(run({"--check"}), 0);
  EXPECT_FALSE(fs::exists(folder_ / "state"));
}

TEST_F(Starting, EveryFaultOfTheConfigurationIsToldAndTheCodeIsTwo) {
  write("footholdd.yaml", "robots_dir: robots\nstate_dir: state\nquene_limit: 3\ngrace: long\n");
  EXPECT_EQ(run({}), 2);
  EXPECT_NE(log().find("footholdd.yaml:3: quene_limit: is not known here; is 'queue_limit' meant?"), std::string::npos) << log();
  EXPECT_NE(log().find("footholdd.yaml:4: grace: must be a time"), std::string::npos) << log();
}

TEST_F(Starting, AFaultOfARobotsFileHasItsLine) {
  write("robots/r.yaml", "robot: r\nplugin: many\nslots: none\n");
  EXPECT_EQ(run({"--check"}), 2);
  EXPECT_NE(log().find("robots/r.yaml:3: slots: must be a whole number (is 'none')"), std::string::npos) << log();
}

TEST_F(Starting, WrongWordsAreRefused) {
  EXPECT_EQ(run({"--dds", "opendds"}), 2);
  EXPECT_NE(log().find("--dds"), std::string::npos);
  EXPECT_EQ(run({"--domain", "201"}), 2);
  EXPECT_EQ(run({"--nonsense"}), 2);
}

TEST_F(Starting, AJournalThatIsNoneIsRefusedWithTheFile) {
  fs::create_directories(folder_ / "state");
  write("state/journal.db", std::string(5000, 'x'));
  EXPECT_EQ(run({}), 3);
  EXPECT_NE(log().find("journal.db: is not a journal of foothold"), std::string::npos) << log();
}

TEST_F(Starting, AStateFolderThatCannotBeMadeIsRefused) {
  write("state", "a file");
  EXPECT_EQ(run({}), 3);
  EXPECT_NE(log().find("the state folder cannot be made"), std::string::npos) << log();
}

TEST_F(Starting, ANetworkConfigurationThatIsNoneIsRefused) {
  write("net.xml", "this is not XML");
  write("footholdd.yaml", "robots_dir: robots\nstate_dir: state\ndds: {network_config: net.xml}\n");
  EXPECT_EQ(run({}), 4) << log();
}

TEST_F(Starting, AStateFolderInUseIsRefused) {
  const DaemonOptions options{.domain = 61, .robots = {good_robot("good")}};
  Daemon first(options);
  Wire wire("cyclone", options.domain);
  ASSERT_TRUE(wire.connect("good"));
  // The first server's folder, found by the journal that it holds open.
  std::string state;
  for (const auto& entry : fs::directory_iterator("/proc/" + std::to_string(first.pid()) + "/fd")) {
    std::error_code ignored;
    const fs::path file = fs::read_symlink(entry.path(), ignored);
    if (file.filename() == "journal.db") state = file.parent_path().string();
  }
  ASSERT_FALSE(state.empty());
  EXPECT_EQ(run({"--state-dir", state}), 3);
  EXPECT_NE(log().find("another footholdd uses this state folder"), std::string::npos) << log();
  EXPECT_EQ(first.stop(), 0);
}

TEST_F(Starting, ASecondStartKeepsTheServersId) {
  const DaemonOptions options{.domain = 62, .robots = {good_robot("good")}};
  Daemon daemon(options);
  const auto id = [&] {
    Wire wire("cyclone", options.domain);
    const bool heard = wire.connect("good") && wire.wait_until(10.0, [&] { return wire.server().has_value(); });
    return heard ? msg::Id(wire.server()->key()) : msg::kNoId;
  };
  const msg::Id before = id();
  EXPECT_NE(before, msg::kNoId);
  daemon.kill();
  daemon.start();
  EXPECT_EQ(id(), before);
  EXPECT_EQ(daemon.stop(), 0);
}

}  // namespace
}  // namespace foothold::test
