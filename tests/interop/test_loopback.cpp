// Nothing leaves 127.0.0.1 and nothing from elsewhere enters, whatever the environment says, unless network_config says otherwise.
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "numbered.hpp"
#include "pair.hpp"
#include "two_machines.hpp"

namespace foothold::interop {
namespace {

using test::numbered;
using transport::BusError;
using transport::open_bus;
using transport::Topic;

// Configurations that use every interface and multicast, as the vendors do by themselves.
constexpr const char* kOpenCyclone =
    "<CycloneDDS><Domain><General><AllowMulticast>true</AllowMulticast></General></Domain></CycloneDDS>";
constexpr const char* kOpenFast = R"(<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns="http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles"><profiles>
<participant profile_name="foothold" is_default_profile="true"><rtps><useBuiltinTransports>true</useBuiltinTransports></rtps></participant>
</profiles></dds>)";

class Loopback : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("foothold-loopback-" + std::to_string(getpid()));
    std::filesystem::create_directory(folder_);
    std::ofstream(folder_ / "cyclone.xml") << kOpenCyclone;
    std::ofstream(folder_ / "fastdds.xml") << kOpenFast;
  }
  void TearDown() override {
    std::filesystem::remove_all(folder_);
    for (const char* name : {"CYCLONEDDS_URI", "FASTRTPS_DEFAULT_PROFILES_FILE", "ROS_DISCOVERY_SERVER"}) unsetenv(name);
  }
  std::string open_configuration() const { return (folder_ / (GetParam() + ".xml")).string(); }
  void set_hostile_environment() const {
    setenv("CYCLONEDDS_URI", ("file://" + (folder_ / "cyclone.xml").string()).c_str(), 1);
    setenv("FASTRTPS_DEFAULT_PROFILES_FILE", (folder_ / "fastdds.xml").c_str(), 1);
  }
  // Two processes that talk, for three seconds if discovery shall repeat itself.
  void talk(const std::string& network_config, std::uint32_t messages, const std::function<void()>& meanwhile) const {
    auto reading = bus_peer(GetParam(), "read", Topic::kQuery);
    auto writing = bus_peer(GetParam(), "write", Topic::kQuery);
    reading.push_back(network_config);
    writing.push_back(network_config);
    Peer reader(reading);
    ASSERT_TRUE(reader.wait_ready());
    Peer writer(writing);
    ASSERT_TRUE(reader.wait_number(Kind::kMatched, 1));
    ASSERT_TRUE(writer.wait_number(Kind::kMatched, 1));
    for (std::uint32_t i = 0; i < messages; ++i) {
      writer.send(numbered(i, 100));
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    ASSERT_TRUE(reader.wait_messages(1));
    meanwhile();
    EXPECT_EQ(writer.finish(), 0);
    EXPECT_EQ(reader.finish(), 0);
  }

 private:
  std::filesystem::path folder_;
};

INSTANTIATE_TEST_SUITE_P(Vendors, Loopback, testing::ValuesIn(kVendors), vendor_name);

TEST_P(Loopback, NothingLeavesAndNothingEnters) {
  if (!TwoMachines::allowed()) GTEST_SKIP() << "may not make network namespaces";
  TwoMachines machines;
  set_hostile_environment();
  talk("", 30, [&] {
    EXPECT_EQ(machines.packets_out(), 0U);
    const auto ports = TwoMachines::open_ports();
    EXPECT_GE(ports.size(), 4U);
    for (const std::uint16_t port : ports) EXPECT_TRUE(machines.refuses(port)) << port;
  });
}

TEST_P(Loopback, ThisTestSeesWhatAnOpenConfigurationSendsAndTakes) {
  if (!TwoMachines::allowed()) GTEST_SKIP() << "may not make network namespaces";
  TwoMachines machines;
  talk(open_configuration(), 30, [&] {
    EXPECT_GT(machines.packets_out(), 0U);
    bool all_refused = true;
    for (const std::uint16_t port : TwoMachines::open_ports()) all_refused = all_refused && machines.refuses(port);
    EXPECT_FALSE(all_refused);
  });
}

TEST_P(Loopback, RefusesAConfigurationThatCannotBeRead) {
  try {
    open_bus({.vendor = GetParam(), .domain = test_domain(), .network_config = "/no/such.xml"});
    FAIL() << "opened";
  } catch (const BusError& error) {
    EXPECT_NE(std::string(error.what()).find("network_config: cannot read '/no/such.xml'"), std::string::npos) << error.what();
  }
}

TEST(FastDds, RefusesAnEnvironmentThatWouldChangeItsDiscovery) {
  setenv("ROS_DISCOVERY_SERVER", "10.0.0.7:11811", 1);
  EXPECT_THROW(open_bus({.vendor = "fastdds", .domain = test_domain()}), BusError);
  unsetenv("ROS_DISCOVERY_SERVER");
}

TEST(FastDds, RefusesAProfilesFileWithoutTheProfileFoothold) {
  const auto path = std::filesystem::temp_directory_path() / ("foothold-noprofile-" + std::to_string(getpid()) + ".xml");
  std::string text = kOpenFast;
  text.replace(text.find("foothold"), 8, "another1");
  std::ofstream(path) << text;
  EXPECT_THROW(open_bus({.vendor = "fastdds", .domain = test_domain(), .network_config = path.string()}), BusError);
  std::filesystem::remove(path);
}

TEST(OpenBus, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(open_bus({.vendor = "opensplice"}), BusError);
  EXPECT_THROW(open_bus({.vendor = "cyclone", .domain = transport::kMaxDomain + 1}), BusError);
}

// The files that others on the host may use, and the examples with their addresses replaced.
TEST_P(Loopback, TheFilesOfThisRepositoryWork) {
  for (const std::string name : {"loopback", "robot-network"}) {
    std::ifstream file(FOOTHOLD_CONFIG "/dds/" + GetParam() + "-" + name + ".xml");
    std::stringstream text;
    text << file.rdbuf();
    std::string words = text.str();
    ASSERT_FALSE(words.empty()) << name;
    for (const std::string address : {"10.0.0.1", "10.0.0.2"}) {
      for (std::size_t at = words.find(address + "<"); at != std::string::npos; at = words.find(address + "<"))
        words.replace(at, 8, "127.0.0.1");
      for (std::size_t at = words.find(address + "\""); at != std::string::npos; at = words.find(address + "\""))
        words.replace(at, 8, "127.0.0.1");
    }
    std::ofstream(open_configuration()) << words;
    talk(open_configuration(), 1, [] {});
  }
}

}  // namespace
}  // namespace foothold::interop
