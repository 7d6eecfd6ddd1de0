// Plans with DDS Security on, for every vendor pair, and servers that do not start with credentials that are none.
#include <gtest/gtest.h>

#include "credentials.hpp"
#include "daemon.hpp"
#include "eventually.hpp"
#include "foothold/client/client.hpp"
#include "planners.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

constexpr std::uint32_t kDomain = 23;
constexpr std::uint32_t kSteps = 200;

class Secured : public testing::TestWithParam<VendorPair> {
 protected:
  Fleet fleet_;
};
INSTANTIATE_TEST_SUITE_P(Pairs, Secured, testing::ValuesIn(kVendorPairs), pair_name);

TEST_P(Secured, PlansArriveWholeInOrderAndEndOnce) {
  Daemon daemon({.vendor = GetParam().server,
                 .domain = kDomain,
                 .robots = {good_robot("good", 2)},
                 .security = fleet_.issue("yard-1", security::Role::kServer)});
  const std::string credentials = fleet_.issue("robot-7", security::Role::kClient);
  client::Client client({.vendor = GetParam().client, .domain = kDomain, .security = credentials});
  EXPECT_TRUE(security::is_id_of(security::read_credentials(credentials, GetParam().client), client.id()));
  ASSERT_TRUE(client.wait_for_robot("good", 20.0));
  ASSERT_TRUE(client.wait_for_server(20.0));
  for (int plans = 0; plans < 5; ++plans) {
    std::uint32_t next = 0;
    client::Plan plan = client.submit(paced_request("good", kSteps, 0.0));
    for (const msg::Step& step : plan) EXPECT_EQ(step.index(), next++);
    EXPECT_EQ(next, kSteps);
    const auto end = plan.wait(20.0);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->state(), msg::SUCCEEDED) << describe(*end);
  }
  EXPECT_NE(daemon.log().find("DDS Security is on, as yard-1"), std::string::npos);
  EXPECT_EQ(daemon.stop(), 0);
}

// Two programs of one holder: each has a partition of its own. (One is always on Fast DDS: see domain.cpp of Cyclone's bus.)
TEST_P(Secured, ProgramsOfOneHolderDoNotHearEachOther) {
  Daemon daemon({.vendor = GetParam().server,
                 .domain = kDomain,
                 .robots = {good_robot("good", 2)},
                 .security = fleet_.issue("yard-1", security::Role::kServer)});
  const std::string credentials = fleet_.issue("robot-7", security::Role::kClient);
  Wire one(GetParam().client, kDomain, {}, client_id(credentials, GetParam().client), credentials);
  Wire other("fastdds", kDomain, {}, client_id(credentials, "fastdds"), credentials);
  ASSERT_TRUE(one.connect("good"));
  ASSERT_TRUE(other.connect("good"));
  const msg::Id id = one.submit(paced_request("good", 20, 0.0));
  ASSERT_TRUE(one.final_event(id));
  EXPECT_TRUE(one.wait_for_steps(id, 20));
  const msg::Id own = other.submit(paced_request("good", 20, 0.0));
  ASSERT_TRUE(other.wait_for_steps(own, 20));
  EXPECT_TRUE(other.events(id).empty());
  EXPECT_EQ(other.total_steps(), 20u);
}

class Starting : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Vendors, Starting, testing::ValuesIn(kVendors), vendor_name);

TEST_P(Starting, AServerRefusesAClientsCredentialsAndNamesTheField) {
  const Fleet fleet;
  const std::string folder = fleet.issue("robot-7", security::Role::kClient);
  Daemon daemon({.vendor = GetParam(), .domain = kDomain, .robots = {good_robot("good", 1)}, .security = folder});
  ASSERT_TRUE(eventually([&] { return !daemon.running(); }));
  EXPECT_NE(daemon.log().find("dds.security: " + folder +
                              ": are the credentials of robot-7, for the role client; footholdd needs the role server"),
            std::string::npos)
      << daemon.log();
}

TEST_P(Starting, AServerWithoutCredentialsSaysWhatIsOpen) {
  Daemon daemon({.vendor = GetParam(), .domain = kDomain, .robots = {good_robot("good", 1)}});
  EXPECT_TRUE(eventually([&] {
    return daemon.log().find("DDS Security is off: every program on this host can submit and cancel requests") != std::string::npos;
  }));
  EXPECT_EQ(daemon.stop(), 0);
}

TEST_P(Starting, AClientRefusesAnIdThatItsCredentialsDoNotAllow) {
  const Fleet fleet;
  const std::string folder = fleet.issue("robot-7", security::Role::kClient);
  client::ClientOptions options;
  options.id = client_id(fleet.issue("robot-8", security::Role::kClient), GetParam());
  try {
    client::Client client({.vendor = GetParam(), .domain = kDomain, .security = folder}, options);
    FAIL() << "a client of another's partition was made";
  } catch (const transport::BusError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("a client's id begins with " + security::partition_prefix(security::read_credentials(folder, GetParam()))),
              std::string::npos)
        << error.what();
  }
}

TEST_P(Starting, AProcessTakesASecondBusOrSaysWhyNot) {
  const Fleet fleet;
  const std::string one = fleet.issue("robot-7", security::Role::kClient), other = fleet.issue("robot-8", security::Role::kClient);
  const auto first = transport::open_bus({.vendor = GetParam(), .domain = kDomain, .security = one});
  for (const std::string& second : {one, other, std::string()}) {
    if (GetParam() == "fastdds")
      EXPECT_NO_THROW(transport::open_bus({.vendor = GetParam(), .domain = kDomain, .security = second}));
    else
      EXPECT_THROW(transport::open_bus({.vendor = GetParam(), .domain = kDomain, .security = second}), transport::BusError);
  }
}

}  // namespace
}  // namespace foothold::test
