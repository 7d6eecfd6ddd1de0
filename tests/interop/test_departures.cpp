// A participant that leaves at the very moment at which its lease ends: the one thread takes it away while the other looks whether
// it is still there. Thousands of them do nobody any harm.
#include <foothold.h>
#include <signal.h>

#include <random>

#include "departures.hpp"
#include "foothold/msg/cdr.hpp"
#include "pair.hpp"

namespace foothold::interop {
namespace {

using transport::Topic;
using transport::Writer;

class LeavingPeers : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Readers, LeavingPeers, testing::ValuesIn(kVendors), vendor_name);

TEST_P(LeavingPeers, AsTheirLeasesEndHarmNobody) {
  constexpr std::uint32_t kRounds = 300, kAtOnce = 40;
  constexpr int kLease = 8;  // ms
  Peer reader(bus_peer(GetParam(), "read", Topic::kQuery));
  ASSERT_TRUE(reader.wait_ready());
  Departures peers(test_domain());
  std::mt19937_64 random(7);
  for (std::uint32_t round = 0; round < kRounds; ++round) {
    const std::uint32_t first = 1 + round * kAtOnce;
    for (std::uint32_t i = 0; i < kAtOnce; ++i) peers.announce(first + i, kLease);
    const bool halts = round % 3 == 0;  // as on a starved machine: it finds leases ended and departures told at the same moment
    std::this_thread::sleep_for(std::chrono::microseconds(1000 * (kLease - 3) + static_cast<int>(random() % 4000)));
    if (halts) ::kill(reader.pid(), SIGSTOP);
    for (std::uint32_t i = 0; i < kAtOnce; ++i) peers.leave(first + i);
    std::this_thread::sleep_for(std::chrono::milliseconds(halts ? 2 : 0));
    if (halts) ::kill(reader.pid(), SIGCONT);
    std::this_thread::sleep_for(std::chrono::milliseconds(kLease));
  }
  const auto bus = transport::open_bus({.vendor = GetParam(), .domain = test_domain()});
  const auto writer = bus->writer(Topic::kQuery, "");
  ASSERT_TRUE(reader.wait_number(Kind::kMatched, 1)) << "it has ended, or hears nobody any more";
  ASSERT_EQ(write_on(*writer, msg::encode(msg::StateQuery())), Writer::Result::kSent);
  EXPECT_TRUE(reader.wait_messages(1));
  EXPECT_EQ(reader.finish(), 0);
}

}  // namespace
}  // namespace foothold::interop
