// What a client may rely on: bursts in order, partitions, keys, the loss of a server noticed, requests that are given to a server
// which is found late, but not to one that is started much later.
#include <atomic>

#include "numbered.hpp"
#include "pair.hpp"

namespace foothold::interop {
namespace {

using test::number_of;
using test::numbered;
using transport::open_bus;
using transport::Topic;
using transport::Writer;

class Delivery : public testing::TestWithParam<Pair> {};
INSTANTIATE_TEST_SUITE_P(Pairs, Delivery, testing::ValuesIn(kPairs), name_of);

// As with a server's writer in the partition of a client that has just come: no wait but for the writer's own match.
TEST_P(Delivery, ABurstOfStepsRightAfterTheMatchArrivesInOrder) {
  constexpr std::uint32_t kSteps = 5000;
  Peer reader(bus_peer(GetParam().reader, "read", Topic::kStep, "client"));
  ASSERT_TRUE(reader.wait_ready());
  const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  const auto writer = bus->writer(Topic::kStep, "client");
  ASSERT_TRUE(eventually([&] { return writer->matched() == 1; }));
  for (std::uint32_t i = 0; i < kSteps; ++i) ASSERT_EQ(write_on(*writer, numbered(i, 300 + i % 1000)), Writer::Result::kSent);
  ASSERT_TRUE(reader.wait_messages(kSteps)) << reader.messages().size();
  const auto messages = reader.messages();
  ASSERT_EQ(messages.size(), kSteps);
  for (std::uint32_t i = 0; i < kSteps; ++i) ASSERT_EQ(number_of(messages[i]), i);
}

TEST_P(Delivery, ARequestWrittenBeforeAnyServerIsFoundArrives) {
  const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  const auto writer = bus->writer(Topic::kRequest, "");
  for (std::uint32_t i = 0; i < 5; ++i) ASSERT_EQ(writer->write(numbered(i, 200)), Writer::Result::kSent);
  Peer reader(bus_peer(GetParam().reader, "read", Topic::kRequest));
  ASSERT_TRUE(reader.wait_messages(5)) << reader.messages().size();
}

TEST_P(Delivery, APartitionKeepsOthersOutAndAnObserverSeesAll) {
  Peer one(bus_peer(GetParam().reader, "read", Topic::kEvent, "one"));
  Peer observer(bus_peer(GetParam().reader, "read", Topic::kEvent, "*"));
  ASSERT_TRUE(one.wait_ready() && observer.wait_ready());
  const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  const auto to_one = bus->writer(Topic::kEvent, "one");
  const auto to_two = bus->writer(Topic::kEvent, "two");
  ASSERT_TRUE(eventually([&] { return to_one->matched() == 2 && to_two->matched() == 1; }));
  ASSERT_EQ(write_on(*to_two, numbered(2, 100)), Writer::Result::kSent);
  ASSERT_EQ(write_on(*to_one, numbered(1, 100)), Writer::Result::kSent);
  ASSERT_TRUE(observer.wait_messages(2));
  ASSERT_TRUE(one.wait_messages(1));
  const auto messages = one.messages();
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(number_of(messages[0]), 1U);
}

// Fast DDS keeps 10 keys by default and acknowledges the rest into the void.
TEST_P(Delivery, AReaderSeesMoreServersThanOneWriterMayHold) {
  constexpr std::size_t kWriters = 4;
  constexpr std::size_t kKeys = 50;
  Peer reader(bus_peer(GetParam().reader, "read", Topic::kServer));
  ASSERT_TRUE(reader.wait_ready());
  const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  std::vector<std::unique_ptr<Writer>> writers;
  for (std::size_t w = 0; w < kWriters; ++w) {
    writers.push_back(bus->writer(Topic::kServer, ""));
    ASSERT_TRUE(eventually([&] { return writers.back()->matched() == 1; }));
    for (std::size_t key = 0; key < kKeys; ++key) {
      auto message = numbered(static_cast<std::uint32_t>(w * kKeys + key), 100);
      message[4] = static_cast<std::byte>(w + 1);
      message[5] = static_cast<std::byte>(key);
      ASSERT_EQ(write_on(*writers.back(), message), Writer::Result::kSent);
    }
  }
  ASSERT_TRUE(reader.wait_messages(kWriters * kKeys, 20.0)) << reader.messages().size();
}

TEST_P(Delivery, AServersDeathIsNoticed) {
  std::atomic<std::size_t> alive{0};
  const auto bus = open_bus({.vendor = GetParam().reader, .domain = test_domain()});
  const auto reader = bus->reader(
      Topic::kServer, "", {.on_message = [](std::span<const std::byte>) {}, .on_liveliness = [&](std::size_t n) { alive = n; }});
  Peer server(bus_peer(GetParam().writer, "write", Topic::kServer));
  ASSERT_TRUE(server.wait_number(Kind::kMatched, 1));
  ASSERT_TRUE(eventually([&] {
    server.send(numbered(1, 100));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return alive == 1;
  }));
  // It lives as long as it beats.
  for (int beat = 0; beat < 8; ++beat) {
    server.send(numbered(1, 100));
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    ASSERT_EQ(alive, 1U);
  }
  server.kill_hard();
  const auto killed = std::chrono::steady_clock::now();
  ASSERT_TRUE(eventually([&] { return alive == 0; }, 10.0));
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - killed).count(), 1.5);
}

TEST_P(Delivery, AnOldRequestIsNotGivenToAServerThatIsStartedMuchLater) {
  const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  const auto writer = bus->writer(Topic::kRequest, "");
  ASSERT_EQ(writer->write(numbered(1, 200)), Writer::Result::kSent);
  std::this_thread::sleep_for(std::chrono::seconds(transport::traits(Topic::kRequest).lifespan + 1));
  Peer reader(bus_peer(GetParam().reader, "read", Topic::kRequest));
  ASSERT_TRUE(eventually([&] { return writer->matched() == 1; }));
  ASSERT_EQ(writer->write(numbered(2, 200)), Writer::Result::kSent);
  ASSERT_TRUE(reader.wait_messages(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const auto messages = reader.messages();
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(number_of(messages[0]), 2U);
}

TEST_P(Delivery, LargeMessagesArriveWhole) {
  Peer reader(bus_peer(GetParam().reader, "read", Topic::kEvent, "p"));
  const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  const auto writer = bus->writer(Topic::kEvent, "p");
  ASSERT_TRUE(eventually([&] { return writer->matched() == 1; }));
  std::vector<std::vector<std::byte>> written;
  for (const std::size_t size : {std::size_t{65'000}, std::size_t{66'000}, std::size_t{1'000'000}, transport::kMaxMessage}) {
    written.push_back(numbered(static_cast<std::uint32_t>(written.size()), size));
    for (std::size_t i = 24; i < size; ++i) written.back()[i] = static_cast<std::byte>(i * 2654435761U >> 24U);
    ASSERT_EQ(write_on(*writer, written.back()), Writer::Result::kSent) << writer->last_error();
  }
  ASSERT_TRUE(reader.wait_messages(written.size())) << reader.messages().size();
  const auto messages = reader.messages();
  for (std::size_t i = 0; i < written.size(); ++i) {
    ASSERT_GE(messages[i].size(), written[i].size());  // the wire may pad to whole words
    EXPECT_TRUE(std::equal(written[i].begin(), written[i].end(), messages[i].begin())) << i;
  }
}

// Nothing is called after a reader is gone, however much is under way.
TEST_P(Delivery, ReadersComeAndGoWhileMessagesFlow) {
  const auto from = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  const auto to = open_bus({.vendor = GetParam().reader, .domain = test_domain()});
  const auto writer = from->writer(Topic::kStep, "p");
  std::atomic<bool> stop{false};
  std::thread writing([&] {
    for (std::uint32_t i = 0; !stop; ++i) {
      if (writer->write(numbered(i, 100)) == Writer::Result::kFull) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  for (int round = 0; round < 20; ++round) {
    auto here = std::make_shared<std::atomic<bool>>(true);
    std::atomic<int> got{0};
    auto reader = to->reader(Topic::kStep, "p", {.on_message = [&got, here](std::span<const std::byte>) {
                               EXPECT_TRUE(*here);
                               ++got;
                             }});
    EXPECT_TRUE(eventually([&] { return got > 50; }));
    reader.reset();
    *here = false;
  }
  stop = true;
  writing.join();
}

}  // namespace
}  // namespace foothold::interop
