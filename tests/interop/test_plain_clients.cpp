// Clients that are not ours: plain vendor programs, on both vendors, read and write every type of the wire. What a bus writes goes
// through such a program, decoded and encoded by its generated code, and comes back equal.
#include <foothold.h>

#include <cstdlib>

#include "foothold/msg/cdr.hpp"
#include "pair.hpp"
#include "wire_message.hpp"

namespace foothold::interop {
namespace {

using transport::open_bus;
using transport::Topic;
using transport::Writer;

// Pair: the bus's vendor (writer) and the plain program's (reader).
class PlainClient : public testing::TestWithParam<Pair> {
 protected:
  void SetUp() override {
    setenv("CYCLONEDDS_URI", "file://" FOOTHOLD_CONFIG "/dds/cyclone-loopback.xml", 1);
    setenv("FASTRTPS_DEFAULT_PROFILES_FILE", FOOTHOLD_CONFIG "/dds/fastdds-loopback.xml", 1);
  }
  void TearDown() override {
    unsetenv("CYCLONEDDS_URI");
    unsetenv("FASTRTPS_DEFAULT_PROFILES_FILE");
  }

  template <class Message>
  void expect_equal_through(Topic topic) {
    constexpr std::size_t kMessages = 60;
    Peer plain({"plain_" + GetParam().reader, std::to_string(test_domain()), std::string(transport::traits(topic).name)});
    const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
    std::mutex mutex;
    std::vector<Message> arrived;
    const auto reader = bus->reader(topic, "back", {.on_message = [&](std::span<const std::byte> message) {
                                      auto back = msg::decode<Message>(message);
                                      ASSERT_TRUE(back);
                                      const std::lock_guard lock(mutex);
                                      arrived.push_back(std::move(*back));
                                    }});
    const auto writer = bus->writer(topic, "plain");
    ASSERT_TRUE(eventually([&] { return writer->matched() == 1 && reader->matched() == 1; }));
    std::vector<Message> written;
    for (std::size_t i = 0; i < kMessages; ++i) {
      written.push_back(random_message<Message>(7000 + i));
      ASSERT_EQ(write_on(*writer, msg::encode(written.back())), Writer::Result::kSent) << writer->last_error();
    }
    EXPECT_TRUE(eventually([&] {
      const std::lock_guard lock(mutex);
      return arrived.size() == kMessages;
    }));
    const std::lock_guard lock(mutex);
    ASSERT_EQ(arrived.size(), kMessages);
    sort_by_key(std::span(written));
    sort_by_key(std::span(arrived));
    for (std::size_t i = 0; i < kMessages; ++i) ASSERT_TRUE(arrived[i] == written[i]) << "message " << i;
    EXPECT_EQ(plain.finish(), 0);
  }
};

INSTANTIATE_TEST_SUITE_P(Pairs, PlainClient, testing::ValuesIn(kPairs), name_of);

TEST_P(PlainClient, UnderstandsPlanRequest) { expect_equal_through<msg::PlanRequest>(Topic::kRequest); }
TEST_P(PlainClient, UnderstandsCancelRequest) { expect_equal_through<msg::CancelRequest>(Topic::kCancel); }
TEST_P(PlainClient, UnderstandsStateQuery) { expect_equal_through<msg::StateQuery>(Topic::kQuery); }
TEST_P(PlainClient, UnderstandsPlanEvent) { expect_equal_through<msg::PlanEvent>(Topic::kEvent); }
TEST_P(PlainClient, UnderstandsStep) { expect_equal_through<msg::Step>(Topic::kStep); }
TEST_P(PlainClient, UnderstandsSceneChunk) { expect_equal_through<msg::SceneChunk>(Topic::kScene); }
TEST_P(PlainClient, UnderstandsSceneStatus) { expect_equal_through<msg::SceneStatus>(Topic::kSceneStatus); }
TEST_P(PlainClient, UnderstandsRobotInfo) { expect_equal_through<msg::RobotInfo>(Topic::kRobot); }
TEST_P(PlainClient, UnderstandsServerInfo) { expect_equal_through<msg::ServerInfo>(Topic::kServer); }

}  // namespace
}  // namespace foothold::interop
