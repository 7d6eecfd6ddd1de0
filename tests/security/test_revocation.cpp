// What a revoked or expired certificate is worth, for every vendor pair.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "credentials.hpp"
#include "daemon.hpp"
#include "foothold/client/client.hpp"
#include "planners.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

using security::Role;
namespace fs = std::filesystem;

constexpr std::uint32_t kDomain = 25;

class Revocation : public testing::TestWithParam<VendorPair> {
 protected:
  DaemonOptions server() const {
    return {.vendor = GetParam().server, .domain = kDomain, .robots = {good_robot("good", 2)}, .security = server_};
  }
  bool served(client::Client& client) const {
    client::Plan plan = client.submit(paced_request("good", 5, 0.0));
    const auto end = plan.wait(3.0);
    return end && end->state() == msg::SUCCEEDED;
  }
  Fleet fleet_;
  std::string server_ = fleet_.issue("yard-1", Role::kServer);
};
INSTANTIATE_TEST_SUITE_P(Pairs, Revocation, testing::ValuesIn(kVendorPairs), pair_name);

TEST_P(Revocation, HoldsFromTheServersNextStartOn) {
  const std::string revoked = fleet_.issue("robot-7", Role::kClient);
  const std::string other = fleet_.issue("robot-8", Role::kClient);
  Daemon daemon(server());
  const transport::BusOptions bus{.vendor = GetParam().client, .domain = kDomain, .security = revoked};
  {
    client::Client client(bus);
    ASSERT_TRUE(client.wait_for_server(20.0));
    EXPECT_TRUE(served(client));
  }
  security::revoke(fleet_.authority(), "robot-7");
  fs::copy_file(fleet_.authority() + "/revoked.crl", server_ + "/revoked.crl", fs::copy_options::overwrite_existing);
  {
    client::Client client(bus);
    EXPECT_TRUE(client.wait_for_server(20.0)) << "the list holds at once: say so in config/OPERATING.md";
  }
  EXPECT_EQ(daemon.stop(10.0), 0);
  daemon.start();
  {
    client::Client client({.vendor = GetParam().client, .domain = kDomain, .security = other});
    ASSERT_TRUE(client.wait_for_server(20.0));
  }
  client::Client client(bus);
  EXPECT_FALSE(client.wait_for_server(4.0));
  EXPECT_TRUE(client.servers().empty());
}

// Cyclone DDS looks at the time as it goes on; Fast DDS 2.9 only when two meet.
TEST_P(Revocation, ByTimeEndsWhatWasBegunUnlessBothEndsAreFastDds) {
  Daemon daemon(server());
  const std::string folder = server_ + "-short";
  constexpr double kSeconds = 6.0;
  const auto issued = std::chrono::steady_clock::now();
  security::issue(
      {.authority = fleet_.authority(), .name = "robot-9", .role = Role::kClient, .folder = folder, .days = kSeconds / 86400.0});
  client::Client client({.vendor = GetParam().client, .domain = kDomain, .security = folder});
  ASSERT_TRUE(client.wait_for_server(kSeconds));
  EXPECT_TRUE(served(client));
  std::this_thread::sleep_until(issued + std::chrono::duration<double>(kSeconds + 2.0));
  const bool both_fast = GetParam().server == std::string("fastdds") && GetParam().client == std::string("fastdds");
  EXPECT_EQ(served(client), both_fast) << "say so in config/OPERATING.md";
  EXPECT_THROW(client::Client({.vendor = GetParam().client, .domain = kDomain, .security = folder}), transport::BusError);
}

}  // namespace
}  // namespace foothold::test
