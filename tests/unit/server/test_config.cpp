// Configuration files: what they say, and every fault with file, line and field.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "config/reading.hpp"
#include "config/words.hpp"
#include "temporary_folder.hpp"

namespace foothold::server::testing {
namespace {

using test::TemporaryFolder;

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

class ConfigFiles : public ::testing::Test {
 protected:
  ConfigFiles() {
    std::filesystem::create_directories(folder_.path() / "robots");
    std::filesystem::create_directories(folder_.path() / "plugins");
    std::filesystem::create_directories(folder_.path() / "scenes");
  }
  ServerConfig server(const std::string& text) {
    write(folder_ / "footholdd.yaml", text);
    return read_server_config(folder_ / "footholdd.yaml");
  }
  std::string faults(const std::string& text) {
    try {
      server(text);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  std::vector<RobotConfig> robots() { return read_robots(server("robots_dir: robots\nplugin_dir: plugins\n")); }
  std::string robot_faults(const std::string& text) {
    write(folder_ / "robots/r.yaml", text);
    try {
      robots();
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(ConfigFiles, SayEverything) {
  write(folder_ / "net.xml", "<x/>");
  const auto config = server(R"(
name: lab
dds: {vendor: fastdds, domain: 7, network_config: net.xml}
state_dir: state
plugin_dir: plugins
robots_dir: ./robots
worker: net.xml
queue_limit: 50
admission: {queued_per_client: 20, running_per_client: 3}
budget_max: 10 min
grace: 250 ms
cancel_memory: 5
retention: 2 d
workers: {restart_first: 0.5, restart_longest: 1 min, start_limit: 9, quarantine_crashes: 4, quarantine_window: 2 min, quarantine_time: 3 min}
scenes: {max_bytes: 10 MiB, preload: [scenes]}
metrics: {enabled: false, address: "::1", port: 99}
bundles: {slow: 1 min, keep: 3}
log_level: debug
)");
  EXPECT_EQ(config.name, "lab");
  EXPECT_EQ(config.dds.vendor, "fastdds");
  EXPECT_EQ(config.dds.domain, 7U);
  EXPECT_EQ(config.dds.network_config, folder_ / "net.xml");
  EXPECT_EQ(config.state_dir, folder_ / "state");
  EXPECT_EQ(config.robots_dir, folder_ / "robots");
  EXPECT_EQ(config.queue_limit, 50U);
  EXPECT_EQ(config.admission, (AdmissionConfig{.queued_per_client = 20, .running_per_client = 3}));
  EXPECT_EQ(config.budget_max, 600.0);
  EXPECT_EQ(config.grace, 0.25);
  EXPECT_EQ(config.cancel_memory, 5.0);
  EXPECT_EQ(config.retention, 172800.0);
  EXPECT_EQ(config.workers.restart_first, 0.5);
  EXPECT_EQ(config.workers.restart_longest, 60.0);
  EXPECT_EQ(config.workers.start_limit, 9.0);
  EXPECT_EQ(config.workers.quarantine_crashes, 4U);
  EXPECT_EQ(config.workers.quarantine_window, 120.0);
  EXPECT_EQ(config.workers.quarantine_time, 180.0);
  EXPECT_EQ(config.scenes.max_bytes, 10485760U);
  EXPECT_EQ(config.scenes.preload, std::vector<std::string>{folder_ / "scenes"});
  EXPECT_EQ(config.metrics, (MetricsConfig{.enabled = false, .address = "::1", .port = 99}));
  EXPECT_EQ(config.bundles.slow, 60.0);
  EXPECT_EQ(config.bundles.keep, 3U);
  EXPECT_EQ(config.log_level, "debug");
}

TEST_F(ConfigFiles, WhatIsNotSaidHasItsDefault) {
  const auto config = server("robots_dir: robots\n");
  EXPECT_EQ(config.dds.vendor, "cyclone");
  EXPECT_EQ(config.dds.network_config, "");
  const ServerConfig initial;
  EXPECT_EQ(config.queue_limit, initial.queue_limit);
}

TEST(ShippedConfiguration, IsGoodAndShowsEverySettingWithItsDefault) {
  const auto config = read_server_config(FOOTHOLD_CONFIG "/footholdd.yaml");
  const ServerConfig initial;
  EXPECT_EQ(config.name, initial.name);
  EXPECT_EQ(config.dds.vendor, initial.dds.vendor);
  EXPECT_EQ(config.dds.domain, initial.dds.domain);
  EXPECT_EQ(config.queue_limit, initial.queue_limit);
  EXPECT_EQ(config.admission, initial.admission);
  EXPECT_EQ(config.budget_max, initial.budget_max);
  EXPECT_EQ(config.grace, initial.grace);
  EXPECT_EQ(config.cancel_memory, initial.cancel_memory);
  EXPECT_EQ(config.retention, initial.retention);
  EXPECT_EQ(config.workers.restart_first, initial.workers.restart_first);
  EXPECT_EQ(config.workers.restart_longest, initial.workers.restart_longest);
  EXPECT_EQ(config.workers.start_limit, initial.workers.start_limit);
  EXPECT_EQ(config.workers.quarantine_crashes, initial.workers.quarantine_crashes);
  EXPECT_EQ(config.workers.quarantine_window, initial.workers.quarantine_window);
  EXPECT_EQ(config.workers.quarantine_time, initial.workers.quarantine_time);
  EXPECT_EQ(config.scenes.max_bytes, initial.scenes.max_bytes);
  EXPECT_EQ(config.metrics, initial.metrics);
  EXPECT_EQ(config.bundles.slow, initial.bundles.slow);
  EXPECT_EQ(config.bundles.keep, initial.bundles.keep);
  EXPECT_EQ(config.log_level, initial.log_level);
  EXPECT_FALSE(read_robots(config).empty());
}

struct Fault {
  const char* name;
  const char* text;   // of footholdd.yaml, after "robots_dir: robots" in line 1
  const char* fault;  // the end of the sentence, from the line on
};

class ServerFileFaults : public ConfigFiles, public ::testing::WithParamInterface<Fault> {};

TEST_P(ServerFileFaults, AreToldWithLineAndField) {
  const std::string found = faults(std::string("robots_dir: robots\n") + GetParam().text);
  EXPECT_NE(found.find(folder_ / "footholdd.yaml:" + GetParam().fault), std::string::npos) << found;
  EXPECT_EQ(std::ranges::count(found, '\n'), 0) << "one fault only: " << found;
}

INSTANTIATE_TEST_SUITE_P(
    Config, ServerFileFaults,
    ::testing::Values(
        Fault{"UnknownKey", "queue_limits: 3", "2: queue_limits: is not known here; is 'queue_limit' meant?"},
        Fault{"UnknownKeyFarFromAll", "colour: red", "2: colour: is not known here; known are name, dds, state_dir"},
        Fault{"KeyTwice", "name: a\nname: b", "3: name: is given twice"},
        Fault{"NameEmpty", "name: ''", "2: name: must not be empty"},
        Fault{"NameIsAMap", "name: {a: 1}", "2: name: must be text (is a map)"},
        Fault{"Vendor", "dds: {vendor: opendds}", "2: dds.vendor: must be one of cyclone, fastdds (is 'opendds')"},
        Fault{"DomainTooLarge", "dds:\n  domain: 201", "3: dds.domain: must be 0 to 200 (is '201')"},
        Fault{"DomainNegative", "dds:\n  domain: -1", "3: dds.domain: must be 0 to 200 (is '-1')"},
        Fault{"DomainNotWhole", "dds:\n  domain: 1.5", "3: dds.domain: must be a whole number (is '1.5')"},
        Fault{"DdsUnknownKey", "dds: {domian: 3}", "2: dds.domian: is not known here; is 'domain' meant?"},
        Fault{"DdsIsText", "dds: cyclone", "2: dds: must be a map (is 'cyclone')"},
        Fault{"NetworkConfigMissing", "dds: {network_config: none.xml}", "2: dds.network_config: must be a file that is there"},
        Fault{"PluginDirMissing", "plugin_dir: nowhere", "2: plugin_dir: must be a folder that is there"},
        Fault{"WorkerMissing", "worker: nothing", "2: worker: must be a file that is there"},
        Fault{"StateDirIsAList", "state_dir: [a]", "2: state_dir: must be a path (is a list)"},
        Fault{"QueueLimitZero", "queue_limit: 0", "2: queue_limit: must be 1 to 1e+06 (is '0')"},
        Fault{"QueueLimitWord", "queue_limit: many", "2: queue_limit: must be a whole number (is 'many')"},
        Fault{"QueueLimitEmpty", "queue_limit:", "2: queue_limit: must be a whole number (is empty)"},
        Fault{"QueuedPerClientZero", "admission: {queued_per_client: 0}",
              "2: admission.queued_per_client: must be 1 to 1e+06 (is '0')"},
        Fault{"RunningPerClient", "admission: {running_per_client: -1}",
              "2: admission.running_per_client: must be 0 to 1e+06 (is '-1')"},
        Fault{"AdmissionUnknownKey", "admission: {running: 1}", "2: admission.running: is not known here"},
        Fault{"BudgetNan", "budget_max: .nan", "2: budget_max: must be a time, in seconds or with ms, s, min, h or d (is '.nan')"},
        Fault{"BudgetNegative", "budget_max: -5", "2: budget_max: must be 0.001 to 604800 s (is '-5')"},
        Fault{"GraceUnit", "grace: 5 lightyears", "2: grace: must be a time"},
        Fault{"GraceZero", "grace: 0", "2: grace: must be 0.001 to 60 s (is '0')"},
        Fault{"Retention", "retention: 0.5", "2: retention: must be 1 to"},
        Fault{"BackOff", "workers: {restart_first: 10, restart_longest: 5}",
              "2: workers.restart_longest: must not be below restart_first"},
        Fault{"Quarantine", "workers:\n  quarantine_crashes: 0", "3: workers.quarantine_crashes: must be 1 to 1e+06 (is '0')"},
        Fault{"MaxBytes", "scenes:\n  max_bytes: 5 GB", "3: scenes.max_bytes: must be 1 to 4e+09 octets (is '5 GB')"},
        Fault{"PreloadNotAList", "scenes: {preload: scenes}", "2: scenes.preload: must be a list of paths (is 'scenes')"},
        Fault{"PreloadMissing", "scenes:\n  preload:\n    - scenes\n    - moon",
              "5: scenes.preload[1]: must be a folder that is there"},
        Fault{"MetricsAddress", "metrics:\n  address: localhost",
              "3: metrics.address: must be an IP address as numbers, such as 127.0.0.1 (is 'localhost')"},
        Fault{"MetricsPort", "metrics: {port: 65536}", "2: metrics.port: must be 0 to 65535 (is '65536')"},
        Fault{"LogLevel", "log_level: loud", "2: log_level: must be one of trace, debug"},
        Fault{"NotYaml", "name: [", "2: is not YAML"}),
    [](const auto& tested) { return tested.param.name; });

TEST_F(ConfigFiles, AllFaultsOfAFileAreToldAtOnce) {
  const std::string found = faults("nmae: x\ndds: {vendor: none, domain: 999}\ngrace: long\n");
  EXPECT_EQ(std::ranges::count(found, '\n'), 4) << found;
  for (const char* field : {"nmae", "dds.vendor", "dds.domain", "grace", "robots_dir: is missing"})
    EXPECT_NE(found.find(field), std::string::npos) << field;
}

TEST_F(ConfigFiles, AFileThatIsNotThereIsNamed) {
  try {
    read_server_config(folder_ / "none.yaml");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()), folder_ / "none.yaml: cannot be read");
  }
}

TEST_F(ConfigFiles, ARobotsFileIsReadWithItsNumbers) {
  write(folder_ / "robots/b.yaml", "robot: climber\nplugin: climbing\nslots: 3\nmemory_limit: 512 MiB\nenabled: false\n");
  write(folder_ / "robots/a.yaml", R"(
robot: walker
plugin: ./own.so
description: It walks
model:
  leg: {length: {value: 120, unit: mm, source: "paper: l"}}
)");
  write(folder_ / "robots/readme.txt", "not a robot");
  const auto all = robots();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].name, "walker");
  EXPECT_EQ(all[0].plugin, folder_ / "robots/own.so");
  EXPECT_EQ(all[0].description, "It walks");
  EXPECT_DOUBLE_EQ(all[0].model.number("leg.length", "m"), 0.12);
  EXPECT_TRUE(all[0].enabled);
  EXPECT_EQ(all[1].name, "climber");
  EXPECT_EQ(all[1].plugin, folder_ / "plugins/climbing.so");
  EXPECT_EQ(all[1].slots, 3U);
  EXPECT_EQ(all[1].memory_limit, 512U << 20);
  EXPECT_FALSE(all[1].enabled);
}

class RobotFileFaults : public ConfigFiles, public ::testing::WithParamInterface<Fault> {};

TEST_P(RobotFileFaults, AreToldWithLineAndField) {
  const std::string found = robot_faults(GetParam().text);
  EXPECT_NE(found.find(folder_ / "robots/r.yaml:" + GetParam().fault), std::string::npos) << found;
  EXPECT_EQ(std::ranges::count(found, '\n'), 0) << "one fault only: " << found;
}

INSTANTIATE_TEST_SUITE_P(
    Config, RobotFileFaults,
    ::testing::Values(Fault{"NoRobot", "plugin: p", "1: robot: is missing"}, Fault{"NoPlugin", "robot: r", "1: plugin: is missing"},
                      Fault{"UnknownKey", "robot: r\nplugin: p\nslot: 3", "3: slot: is not known here; is 'slots' meant?"},
                      Fault{"SlotsZero", "robot: r\nplugin: p\nslots: 0", "3: slots: must be 1 to 256 (is '0')"},
                      Fault{"MemoryUnit", "robot: r\nplugin: p\nmemory_limit: 5 XB", "3: memory_limit: must be a size"},
                      Fault{"MemoryTooSmall", "robot: r\nplugin: p\nmemory_limit: 5", "3: memory_limit: must be 1.04858e+06 to"},
                      Fault{"Enabled", "robot: r\nplugin: p\nenabled: 'yes'", "3: enabled: must be true or false (is 'yes')"},
                      Fault{"NameTooLong", "robot: rrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrr\nplugin: p",
                            "1: robot: must have 64 octets at most"},
                      Fault{"ModelWithoutUnit", "robot: r\nplugin: p\nmodel:\n  leg: {value: 3, source: paper}",
                            "4: model.leg.unit: is missing"},
                      Fault{"NotAMap", "- robot", "1: must be a map (is a list)"}),
    [](const auto& tested) { return tested.param.name; });

TEST_F(ConfigFiles, TwoRobotsOfOneNameAreRefused) {
  write(folder_ / "robots/a.yaml", "robot: r\nplugin: p\n");
  EXPECT_NE(
      robot_faults("robot: r\nplugin: p\n").find("r.yaml: robot: 'r' is the name of the robot in " + (folder_ / "robots/a.yaml")),
      std::string::npos);
}

TEST_F(ConfigFiles, AFolderWithoutRobotsIsRefused) { EXPECT_THROW(robots(), ConfigError); }

TEST(Words, FindTheNearestNameOnlyIfItIsNear) {
  EXPECT_EQ(nearest("quene_limit", {"name", "queue_limit"}), "queue_limit");
  EXPECT_EQ(nearest("x", {"name", "queue_limit"}), "");
  EXPECT_EQ(nearest("nmae", {"name"}), "") << "two of four letters";
  EXPECT_EQ(nearest(std::string(30, 'x'), {std::string(39, 'x'), std::string(41, 'x')}), std::string(39, 'x'));
  EXPECT_EQ(nearest(std::string(30, 'x'), {std::string(41, 'x')}), "") << "eleven of thirty letters";
}

TEST(Words, ReadQuantities) {
  EXPECT_EQ(parse_seconds("1.5 min"), 90.0);
  EXPECT_EQ(parse_seconds("100ms"), 0.1);
  EXPECT_EQ(parse_octets("2 KiB"), 2048.0);
  for (const char* wrong : {"", "s", "1 ", "1 m", "inf", "nan", "1 s s", "0x10", "1e308 d"})
    EXPECT_FALSE(parse_seconds(wrong)) << wrong;
}

}  // namespace
}  // namespace foothold::server::testing
