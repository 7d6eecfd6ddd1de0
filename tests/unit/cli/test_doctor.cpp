// The doctor's checks on machines that are set up for the test.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "credentials.hpp"
#include "doctor/check.hpp"

namespace foothold::test {
namespace {

using namespace foothold::cli;
using Level = Finding::Level;
namespace fs = std::filesystem;

class Doctor : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::path(testing::TempDir()) / ("doctor_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    for (const char* part : {"proc/net", "proc/sys/net/core", "proc/sys/net/ipv4", "shm"}) fs::create_directories(folder_ / part);
    machine_.proc = folder_ / "proc";
    machine_.shm = folder_ / "shm";
    machine_.variable = [this](const std::string& name) -> std::optional<std::string> {
      const auto found = variables_.find(name);
      return found == variables_.end() ? std::nullopt : std::optional(found->second);
    };
    machine_.interfaces = {{"lo", true, true, {"127.0.0.1"}}};
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }

  fs::path folder_;
  Surroundings machine_;
  std::map<std::string, std::string> variables_;
};

const Finding* about(const Findings& findings, const std::string& subject) {
  const auto found = std::ranges::find(findings, subject, &Finding::subject);
  return found == findings.end() ? nullptr : &*found;
}

TEST_F(Doctor, FailsWhereLoopbackIsDown) {
  EXPECT_EQ(about(check_interfaces(machine_), "loopback")->level, Level::kOk);
  machine_.interfaces[0].up = false;
  const Findings findings = check_interfaces(machine_);
  EXPECT_EQ(about(findings, "loopback")->level, Level::kFail);
  EXPECT_EQ(about(findings, "loopback")->advice, "ip link set lo up");
}

TEST_F(Doctor, TellsWhatOtherInterfacesAreUp) {
  machine_.interfaces.push_back({"eth0", true, false, {"192.0.2.7"}});
  machine_.interfaces.push_back({"wlan0", false, false, {"192.0.2.8"}});
  EXPECT_EQ(about(check_interfaces(machine_), "interfaces")->message, "also up: eth0 192.0.2.7");
}

TEST_F(Doctor, SaysWhatIsOpenWithoutSecurity) {
  Common common;
  const Findings open = check_security(common);
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].level, Level::kWarn);
  EXPECT_NE(open[0].message.find("every program on this host can submit and cancel requests"), std::string::npos);
  EXPECT_NE(open[0].advice.find("foothold security init"), std::string::npos);
  common.network = "eth.xml";
  EXPECT_NE(check_security(common)[0].message.find("whoever reaches the network"), std::string::npos);
}

TEST_F(Doctor, LooksAtTheCredentialsForBothVendors) {
  const Fleet fleet;
  Common common;
  common.security = fleet.issue("robot-7", security::Role::kClient);
  for (const char* subject : {"DDS Security", "credentials for cyclone", "credentials for fastdds"})
    EXPECT_EQ(about(check_security(common), subject)->level, Level::kOk) << subject;
  EXPECT_NE(about(check_security(common), "credentials for cyclone")->message.find("client robot-7, valid for 36"),
            std::string::npos);
  fs::remove(common.security + "/fastdds.crt");
  EXPECT_EQ(about(check_security(common), "credentials for cyclone")->level, Level::kOk);
  EXPECT_EQ(about(check_security(common), "credentials for fastdds")->level, Level::kFail);
  fs::permissions(common.security + "/identity.key", fs::perms(0644));
  EXPECT_NE(about(check_security(common), "credentials for cyclone")->message.find("chmod 600"), std::string::npos);
  const std::string soon = common.security + "-soon";
  security::issue({.authority = fleet.authority(), .name = "robot-8", .folder = soon, .days = 5});
  common.security = soon;
  EXPECT_EQ(about(check_security(common), "credentials for cyclone")->level, Level::kWarn);
}

TEST_F(Doctor, KnowsWhetherTrafficCanLeaveTheHost) {
  Common common;
  EXPECT_EQ(check_exposure(common)[0].level, Level::kOk);
  common.network = FOOTHOLD_CYCLONE_LOOPBACK;
  EXPECT_EQ(check_exposure(common)[0].level, Level::kOk) << check_exposure(common)[0].message;
  common.network = write("open.xml", "<CycloneDDS><Domain/></CycloneDDS>");
  EXPECT_EQ(check_exposure(common)[0].level, Level::kWarn);
  common.network = write("eth.xml", "<!-- address=\"127.0.0.1\" --><NetworkInterface name=\"eth0\" multicast=\"true\"/>");
  EXPECT_NE(check_exposure(common)[0].message.find("through eth0"), std::string::npos);
  common.dds = "fastdds";
  common.network =
      write("fast.xml", "<interfaceWhiteList><address>127.0.0.1</address><address>192.0.2.7</address></interfaceWhiteList>");
  EXPECT_NE(check_exposure(common)[0].message.find("through 192.0.2.7"), std::string::npos);
  common.network = write("fast2.xml",
                         "<interfaceWhiteList><address>127.0.0.1</address></interfaceWhiteList>"
                         "<useBuiltinTransports>true</useBuiltinTransports>");
  EXPECT_NE(check_exposure(common)[0].message.find("every interface"), std::string::npos);
  common.network = (folder_ / "absent.xml").string();
  EXPECT_EQ(check_exposure(common)[0].level, Level::kFail);
}

TEST_F(Doctor, NamesEachVariableAndWhatItDoes) {
  EXPECT_EQ(about(check_environment(machine_, {}), "environment")->level, Level::kOk);
  variables_ = {{"CYCLONEDDS_URI", "file:///x.xml"}, {"ROS_DISCOVERY_SERVER", "192.0.2.1:11811"}, {"ROS_DOMAIN_ID", "7"}};
  Common common;
  EXPECT_EQ(about(check_environment(machine_, common), "CYCLONEDDS_URI")->level, Level::kOk);
  EXPECT_EQ(about(check_environment(machine_, common), "ROS_DISCOVERY_SERVER")->level, Level::kWarn);
  common.dds = "fastdds";
  EXPECT_EQ(about(check_environment(machine_, common), "ROS_DISCOVERY_SERVER")->level, Level::kFail);
  ASSERT_NE(about(check_environment(machine_, common), "ROS_DOMAIN_ID"), nullptr);
  common.domain = 7;
  EXPECT_EQ(about(check_environment(machine_, common), "ROS_DOMAIN_ID"), nullptr);
}

// Participants 0 to count-1 of a domain as the kernel lists their sockets.
std::string udp_table(std::uint32_t domain, std::uint32_t count) {
  std::string text = "  sl  local_address rem_address   st\n";
  for (std::uint32_t i = 0; i < count; ++i) {
    char line[80];
    std::snprintf(line, sizeof line, " %4u: 0100007F:%04X 00000000:0000 07\n", i, 7400 + 250 * domain + 10 + 2 * i);
    text += line;
  }
  return text;
}

TEST_F(Doctor, CountsTheParticipantsOfTheDomain) {
  Common common;
  common.domain = 3;
  write("proc/net/udp", udp_table(3, 4));
  EXPECT_EQ(about(check_participants(machine_, common), "participants")->message, "4 of 60 participants of domain 3 on this host");
  write("proc/net/udp", udp_table(3, 58));
  EXPECT_EQ(about(check_participants(machine_, common), "participants")->level, Level::kWarn);
  write("proc/net/udp", udp_table(3, 60));
  EXPECT_EQ(about(check_participants(machine_, common), "participants")->level, Level::kFail);
  common.domain = 4;
  EXPECT_EQ(about(check_participants(machine_, common), "participants")->level, Level::kOk);
}

TEST_F(Doctor, WarnsOfADomainWhosePortsTheKernelGivesAway) {
  write("proc/sys/net/ipv4/ip_local_port_range", "32768\t60999\n");
  Common common;
  common.domain = 100;
  EXPECT_EQ(about(check_participants(machine_, common), "ports"), nullptr);
  common.domain = 102;
  ASSERT_NE(about(check_participants(machine_, common), "ports"), nullptr);
  EXPECT_EQ(about(check_participants(machine_, common), "ports")->advice, "use a domain of 0 to 100");
}

TEST_F(Doctor, WarnsOfSmallSocketBuffers) {
  write("proc/sys/net/core/rmem_max", "212992\n");
  EXPECT_EQ(check_socket_buffers(machine_)[0].level, Level::kWarn);
  write("proc/sys/net/core/rmem_max", "4194304\n");
  EXPECT_EQ(check_socket_buffers(machine_)[0].level, Level::kOk);
  fs::remove(folder_ / "proc/sys/net/core/rmem_max");
  EXPECT_EQ(check_socket_buffers(machine_)[0].level, Level::kOk);
}

TEST_F(Doctor, FindsWhatKilledProgramsLeftInSharedMemory) {
  write("shm/of_somebody_else", "x");
  EXPECT_EQ(check_shared_memory(machine_)[0].level, Level::kOk);
  write("shm/fastrtps_port7411", "xxxx");
  write("shm/sem.fastrtps_port7411_mutex", "x");
  const Finding finding = check_shared_memory(machine_)[0];
  EXPECT_EQ(finding.level, Level::kWarn);
  EXPECT_EQ(finding.message.find("2 files of DDS"), 0u);
}

}  // namespace
}  // namespace foothold::test
