// The simplest things of each vendor pair: two processes, and both ends in one process.
#include <foothold.h>

#include <condition_variable>
#include <mutex>

#include "foothold/msg/cdr.hpp"
#include "pair.hpp"

namespace foothold::interop {
namespace {

using transport::open_bus;
using transport::Topic;
using transport::Writer;

class BusOfPair : public testing::TestWithParam<Pair> {};
INSTANTIATE_TEST_SUITE_P(Pairs, BusOfPair, testing::ValuesIn(kPairs), name_of);

msg::Bytes query(std::uint32_t number) {
  msg::StateQuery query;
  query.from_step(number);
  return msg::encode(query);
}

TEST_P(BusOfPair, CarriesMessagesToAnotherProcess) {
  Peer reader(bus_peer(GetParam().reader, "read", Topic::kQuery));
  ASSERT_TRUE(reader.wait_ready());
  const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  const auto writer = bus->writer(Topic::kQuery, "");
  ASSERT_TRUE(reader.wait_number(Kind::kMatched, 1));
  ASSERT_TRUE(eventually([&] { return writer->matched() == 1; }));
  for (std::uint32_t i = 0; i < 100; ++i) ASSERT_EQ(write_on(*writer, query(i)), Writer::Result::kSent) << writer->last_error();
  ASSERT_TRUE(reader.wait_messages(100));
  const auto messages = reader.messages();
  for (std::uint32_t i = 0; i < 100; ++i) {
    const auto back = msg::decode<msg::StateQuery>(messages[i]);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->from_step(), i);
  }
  EXPECT_TRUE(writer->wait_acknowledged(5.0));
  EXPECT_EQ(reader.finish(), 0);
}

TEST_P(BusOfPair, CarriesMessagesWithinOneProcess) {
  const auto from = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  const auto to = open_bus({.vendor = GetParam().reader, .domain = test_domain()});
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<msg::Bytes> got;
  const auto reader = to->reader(Topic::kQuery, "one", {.on_message = [&](std::span<const std::byte> message) {
                                   const std::lock_guard lock(mutex);
                                   got.emplace_back(message.begin(), message.end());
                                   changed.notify_all();
                                 }});
  const auto writer = from->writer(Topic::kQuery, "one");
  ASSERT_TRUE(eventually([&] { return reader->matched() == 1 && writer->matched() == 1; }));
  ASSERT_EQ(write_on(*writer, query(17)), Writer::Result::kSent) << writer->last_error();
  std::unique_lock lock(mutex);
  ASSERT_TRUE(changed.wait_for(lock, std::chrono::seconds(20), [&] { return !got.empty(); }));
  const auto back = msg::decode<msg::StateQuery>(got.front());
  ASSERT_TRUE(back);
  EXPECT_EQ(back->from_step(), 17U);
}

}  // namespace
}  // namespace foothold::interop
