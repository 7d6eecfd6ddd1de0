// Every message type with random contents, on all vendor pairs: what arrives is what was written.
#include <foothold.h>

#include "foothold/msg/cdr.hpp"
#include "pair.hpp"
#include "wire_message.hpp"

namespace foothold::interop {
namespace {

using transport::open_bus;
using transport::Topic;
using transport::Writer;

class Messages : public testing::TestWithParam<Pair> {
 protected:
  // Six rounds of 50, each waited for: in a keyed topic the newest sample of a key replaces the one before. Every round has the
  // same keys.
  template <class Message>
  void expect_equal_after_the_wire(Topic topic) {
    constexpr std::size_t kRound = 50;
    std::uint64_t seed = 1000 * (1 + static_cast<std::uint64_t>(topic));
    Peer reader(bus_peer(GetParam().reader, "read", topic, "somewhere"));
    const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
    const auto writer = bus->writer(topic, "somewhere");
    ASSERT_TRUE(eventually([&] { return writer->matched() == 1; }));
    std::vector<Message> written;
    for (std::size_t round = 1; round <= 6; ++round) {
      for (std::size_t i = 0; i < kRound; ++i) {
        written.push_back(random_message<Message>(seed++));
        if constexpr (requires { written.back().key(); }) {
          if (round > 1) written.back().key(written[i].key());
        }
        ASSERT_EQ(write_on(*writer, msg::encode(written.back())), Writer::Result::kSent) << writer->last_error();
      }
      ASSERT_TRUE(reader.wait_messages(round * kRound)) << reader.messages().size();
    }
    std::vector<Message> arrived;
    for (const auto& message : reader.messages()) {
      auto back = msg::decode<Message>(message);
      ASSERT_TRUE(back) << "message " << arrived.size();
      arrived.push_back(std::move(*back));
    }
    ASSERT_EQ(arrived.size(), written.size());
    for (std::size_t begin = 0; begin < written.size(); begin += kRound) {
      sort_by_key(std::span(written).subspan(begin, kRound));
      sort_by_key(std::span(arrived).subspan(begin, kRound));
    }
    for (std::size_t i = 0; i < written.size(); ++i) ASSERT_TRUE(arrived[i] == written[i]) << "message " << i;
    EXPECT_EQ(reader.finish(), 0);
  }
};

INSTANTIATE_TEST_SUITE_P(Pairs, Messages, testing::ValuesIn(kPairs), name_of);

TEST_P(Messages, PlanRequestArrivesEqual) { expect_equal_after_the_wire<msg::PlanRequest>(Topic::kRequest); }
TEST_P(Messages, CancelRequestArrivesEqual) { expect_equal_after_the_wire<msg::CancelRequest>(Topic::kCancel); }
TEST_P(Messages, StateQueryArrivesEqual) { expect_equal_after_the_wire<msg::StateQuery>(Topic::kQuery); }
TEST_P(Messages, PlanEventArrivesEqual) { expect_equal_after_the_wire<msg::PlanEvent>(Topic::kEvent); }
TEST_P(Messages, StepArrivesEqual) { expect_equal_after_the_wire<msg::Step>(Topic::kStep); }
TEST_P(Messages, SceneChunkArrivesEqual) { expect_equal_after_the_wire<msg::SceneChunk>(Topic::kScene); }
TEST_P(Messages, SceneStatusArrivesEqual) { expect_equal_after_the_wire<msg::SceneStatus>(Topic::kSceneStatus); }
TEST_P(Messages, RobotInfoArrivesEqual) { expect_equal_after_the_wire<msg::RobotInfo>(Topic::kRobot); }
TEST_P(Messages, ServerInfoArrivesEqual) { expect_equal_after_the_wire<msg::ServerInfo>(Topic::kServer); }

}  // namespace
}  // namespace foothold::interop
