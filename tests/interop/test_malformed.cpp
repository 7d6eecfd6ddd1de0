// Octets that are no message never end a reader's process: it tells them from messages and goes on.
#include <foothold.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "foothold/msg/cdr.hpp"
#include "numbered.hpp"
#include "pair.hpp"
#include "wire_message.hpp"

namespace foothold::interop {
namespace {

using test::numbered;
using transport::open_bus;
using transport::Topic;
using transport::Writer;
using Octets = std::vector<std::byte>;

class Malformed : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { setenv("FASTRTPS_DEFAULT_PROFILES_FILE", FOOTHOLD_CONFIG "/dds/fastdds-loopback.xml", 1); }
  void TearDown() override { unsetenv("FASTRTPS_DEFAULT_PROFILES_FILE"); }

  // Cut short, octets changed, lengths made huge, or noise: behind the encapsulation and, if keyed, the key.
  static Octets spoil(Octets message, std::size_t from, std::mt19937_64& random) {
    const auto below = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
    const std::size_t size = message.size() - from;
    switch (below(4)) {
      case 0:
        message.resize(from + below(size));
        break;
      case 1:
        for (std::size_t i = 1 + below(8); i > 0; --i) message[from + below(size)] = static_cast<std::byte>(random());
        break;
      case 2:
        std::memset(message.data() + from + 4 * below(size / 4), below(2) == 0 ? 0xff : 0x7f, 4);
        break;
      default:
        message.resize(from + below(2000));
        for (std::size_t i = from; i < message.size(); ++i) message[i] = static_cast<std::byte>(random());
    }
    return message;
  }

  static std::vector<std::string> raw_writer(Topic topic) {
    const transport::TopicTraits& traits = transport::traits(topic);
    return {"raw_fastdds", std::to_string(test_domain()), std::string(traits.name), std::string(traits.type)};
  }

  template <class Message>
  void expect_survival(Topic topic) {
    constexpr std::size_t kSpoilt = 1000;
    Peer reader(bus_peer(GetParam(), "decode", topic));
    ASSERT_TRUE(reader.wait_ready());
    Peer writer(raw_writer(topic));
    ASSERT_TRUE(writer.wait_number(Kind::kMatched, 1));
    ASSERT_TRUE(reader.wait_number(Kind::kMatched, 1));
    std::mt19937_64 random(static_cast<std::uint64_t>(topic));
    const std::size_t from = transport::traits(topic).keyed ? 20 : 4;
    for (std::size_t i = 1; i <= kSpoilt; ++i) {
      ASSERT_TRUE(writer.send(spoil(msg::encode(random_message<Message>(i)), from, random)));
      // In a keyed topic the newest replaces the one before.
      if (from == 20) {
        ASSERT_TRUE(reader.wait_messages(i));
      }
    }
    ASSERT_TRUE(writer.send(msg::encode(random_message<Message>(3))));
    ASSERT_TRUE(reader.wait_messages(kSpoilt + 1)) << reader.messages().size();
    const auto verdicts = reader.messages();
    EXPECT_EQ(verdicts.back(), Octets{std::byte{1}});
    EXPECT_GT(std::count(verdicts.begin(), verdicts.end(), Octets{std::byte{0}}), 100);
    EXPECT_EQ(reader.finish(), 0);
  }
};

INSTANTIATE_TEST_SUITE_P(Readers, Malformed, testing::ValuesIn(kVendors), vendor_name);

TEST_P(Malformed, PlanRequestsEndNoReader) { expect_survival<msg::PlanRequest>(Topic::kRequest); }
TEST_P(Malformed, CancelRequestsEndNoReader) { expect_survival<msg::CancelRequest>(Topic::kCancel); }
TEST_P(Malformed, StateQueriesEndNoReader) { expect_survival<msg::StateQuery>(Topic::kQuery); }
TEST_P(Malformed, PlanEventsEndNoReader) { expect_survival<msg::PlanEvent>(Topic::kEvent); }
TEST_P(Malformed, StepsEndNoReader) { expect_survival<msg::Step>(Topic::kStep); }
TEST_P(Malformed, SceneChunksEndNoReader) { expect_survival<msg::SceneChunk>(Topic::kScene); }
TEST_P(Malformed, SceneStatusEndsNoReader) { expect_survival<msg::SceneStatus>(Topic::kSceneStatus); }
TEST_P(Malformed, RobotInfoEndsNoReader) { expect_survival<msg::RobotInfo>(Topic::kRobot); }
TEST_P(Malformed, ServerInfoEndsNoReader) { expect_survival<msg::ServerInfo>(Topic::kServer); }

// No encapsulation that XCDR1 knows, or none at all: a reader may wait for ever for that writer's next sample, but not for others'.
TEST_P(Malformed, NoiseFromOneWriterDoesNotStopTheOthers) {
  for (const Topic topic : {Topic::kQuery, Topic::kServer}) {
    Peer reader(bus_peer(GetParam(), "read", topic), Peer::Errors::kHidden);
    ASSERT_TRUE(reader.wait_ready());
    Peer noisy(raw_writer(topic));
    ASSERT_TRUE(noisy.wait_number(Kind::kMatched, 1));
    std::mt19937_64 random(5);
    for (int i = 0; i < 500; ++i) {
      Octets noise(1 + random() % 300);
      for (std::byte& octet : noise) octet = static_cast<std::byte>(random());
      ASSERT_TRUE(noisy.send(noise));
    }
    const auto bus = open_bus({.vendor = GetParam(), .domain = test_domain()});
    const auto sound = bus->writer(topic, "");
    ASSERT_TRUE(eventually([&] { return sound->matched() == 1; }));
    const Octets message = numbered(1, 96);
    ASSERT_EQ(write_on(*sound, message), Writer::Result::kSent);
    EXPECT_TRUE(eventually([&] {
      const auto messages = reader.messages();
      return std::find(messages.begin(), messages.end(), message) != messages.end();
    }));
    noisy.kill_hard();
    EXPECT_EQ(reader.finish(), 0);
  }
}

TEST_P(Malformed, OurOwnWriterRefusesThemWithTheReason) {
  const auto bus = open_bus({.vendor = GetParam(), .domain = test_domain()});
  const auto keyless = bus->writer(Topic::kQuery, "");
  const auto keyed = bus->writer(Topic::kServer, "");
  Octets message = numbered(1, 100);
  EXPECT_EQ(keyless->write(std::span(message).first(3)), Writer::Result::kFailed);
  EXPECT_EQ(keyless->last_error(), "a message of 3 octets on foothold/query is too short");
  EXPECT_EQ(keyed->write(std::span(message).first(19)), Writer::Result::kFailed);
  EXPECT_EQ(keyed->last_error(), "a message of 19 octets on foothold/server is too short");
  message[1] = std::byte{7};
  EXPECT_EQ(keyless->write(message), Writer::Result::kFailed);
  EXPECT_EQ(keyless->last_error(), "a message of 100 octets on foothold/query does not begin as XCDR1");
  EXPECT_EQ(keyless->write(numbered(1, transport::kMaxMessage + 1)), Writer::Result::kFailed);
  EXPECT_EQ(keyless->last_error(), "a message of 16777217 octets on foothold/query is longer than 16 MiB");
  EXPECT_EQ(keyless->write(numbered(1, 100)), Writer::Result::kSent);
}

}  // namespace
}  // namespace foothold::interop
