// What a writer keeps: late readers get the newest samples, a full history rolls over, a slow reader makes it full for a while.
#include <foothold.h>
#include <signal.h>

#include "foothold/msg/cdr.hpp"
#include "numbered.hpp"
#include "pair.hpp"

namespace foothold::interop {
namespace {

using test::number_of;
using test::numbered;
using transport::open_bus;
using transport::Topic;
using transport::Writer;

constexpr Topic kKept[] = {Topic::kEvent, Topic::kStep};

class HistoryOfVendor : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Vendors, HistoryOfVendor, testing::ValuesIn(kVendors), vendor_name);

TEST_P(HistoryOfVendor, RollsOverWithoutAReader) {
  const auto bus = open_bus({.vendor = GetParam(), .domain = test_domain()});
  for (const Topic topic : kKept) {
    const auto writer = bus->writer(topic, "p");
    const auto count = static_cast<std::uint32_t>(5 * transport::traits(topic).history);
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(writer->write(numbered(i, 200)), Writer::Result::kSent) << "sample " << i;
  }
}

class HistoryOfPair : public testing::TestWithParam<Pair> {};
INSTANTIATE_TEST_SUITE_P(Pairs, HistoryOfPair, testing::ValuesIn(kPairs), name_of);

void expect_numbers(const std::vector<std::vector<std::byte>>& messages, std::uint32_t first, std::uint32_t count) {
  ASSERT_EQ(messages.size(), count);
  for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(number_of(messages[i]), first + i) << "at " << i;
}

TEST_P(HistoryOfPair, RollsOverWithAReaderAndLosesNothing) {
  for (const Topic topic : kKept) {
    Peer reader(bus_peer(GetParam().reader, "read", topic, "p"));
    const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
    const auto writer = bus->writer(topic, "p");
    ASSERT_TRUE(eventually([&] { return writer->matched() == 1; }));
    const auto count = static_cast<std::uint32_t>(5 * transport::traits(topic).history);
    for (std::uint32_t i = 0; i < count; ++i)
      ASSERT_EQ(write_on(*writer, numbered(i, 200)), Writer::Result::kSent) << "sample " << i;
    ASSERT_TRUE(reader.wait_messages(count)) << reader.messages().size();
    EXPECT_TRUE(writer->wait_acknowledged(5.0));
    expect_numbers(reader.messages(), 0, count);
  }
}

TEST_P(HistoryOfPair, GivesALateReaderTheNewestSamples) {
  const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  const auto writer = bus->writer(Topic::kEvent, "p");
  const auto kept = static_cast<std::uint32_t>(transport::traits(Topic::kEvent).history);
  const std::uint32_t written = kept + 1000;
  for (std::uint32_t i = 0; i < written; ++i) ASSERT_EQ(write_on(*writer, numbered(i, 200)), Writer::Result::kSent);
  Peer reader(bus_peer(GetParam().reader, "read", Topic::kEvent, "p"));
  ASSERT_TRUE(reader.wait_messages(kept)) << reader.messages().size();
  expect_numbers(reader.messages(), written - kept, kept);
}

TEST_P(HistoryOfPair, IsFullWhileAReaderLagsAndLosesNothing) {
  Peer reader(bus_peer(GetParam().reader, "read", Topic::kStep, "p"));
  const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
  const auto writer = bus->writer(Topic::kStep, "p");
  ASSERT_TRUE(reader.wait_number(Kind::kMatched, 1));
  ASSERT_TRUE(eventually([&] { return writer->matched() == 1; }));
  // The reader's process stands still, for less than its lease.
  kill(reader.pid(), SIGSTOP);
  std::uint32_t sent = 0;
  Writer::Result result = Writer::Result::kSent;
  while (sent < 100'000 && (result = writer->write(numbered(sent, 4000))) == Writer::Result::kSent) ++sent;
  kill(reader.pid(), SIGCONT);
  EXPECT_EQ(result, Writer::Result::kFull);
  EXPECT_LT(sent, 100'000U);
  ASSERT_TRUE(reader.wait_messages(sent)) << reader.messages().size() << " of " << sent;
  ASSERT_EQ(write_on(*writer, numbered(sent, 4000)), Writer::Result::kSent);
  ASSERT_TRUE(reader.wait_messages(sent + 1));
  expect_numbers(reader.messages(), 0, sent + 1);
}

// A writer with two readers, of which one stands still.
struct OneHalted {
  OneHalted(const Pair& vendors, Topic topic)
      : halted(bus_peer(vendors.reader, "read", topic)),
        other(bus_peer(vendors.reader, "read", topic)),
        bus(open_bus({.vendor = vendors.writer, .domain = test_domain()})),
        writer(bus->writer(topic, "")) {
    const bool matched = eventually([&] { return writer->matched() == 2; });
    EXPECT_TRUE(matched && halted.wait_number(Kind::kMatched, 1) && other.wait_number(Kind::kMatched, 1));
    kill(halted.pid(), SIGSTOP);
  }
  void go_on() const { kill(halted.pid(), SIGCONT); }

  Peer halted, other;
  std::unique_ptr<transport::Bus> bus;
  std::unique_ptr<Writer> writer;
};

// Who has died without a word is a reader until its lease ends; what a thousand messages are to others does not wait for that.
TEST_P(HistoryOfPair, AReaderThatStandsStillDoesNotStopTheOthers) {
  OneHalted readers(GetParam(), Topic::kStep);
  ASSERT_FALSE(HasFailure());
  constexpr std::uint32_t kCount = 1000;
  for (std::uint32_t i = 0; i < kCount; ++i)
    ASSERT_EQ(write_on(*readers.writer, numbered(i, 100), 5.0), Writer::Result::kSent) << "sample " << i;
  EXPECT_TRUE(readers.other.wait_messages(kCount)) << readers.other.messages().size();
  readers.go_on();
  ASSERT_TRUE(readers.halted.wait_messages(kCount)) << readers.halted.messages().size();
  expect_numbers(readers.other.messages(), 0, kCount);
  expect_numbers(readers.halted.messages(), 0, kCount);
}

// A heartbeat is not held up by whoever has died without a word.
TEST_P(HistoryOfPair, TheNewestValueWaitsForNoReader) {
  OneHalted readers(GetParam(), Topic::kServer);
  ASSERT_FALSE(HasFailure());
  msg::ServerInfo info;
  info.name(std::string(500, 'a'));
  constexpr std::uint64_t kBeats = 1000;
  for (std::uint64_t beat = 1; beat <= kBeats; ++beat) {
    info.heartbeat(beat);
    ASSERT_EQ(readers.writer->write(msg::encode(info)), Writer::Result::kSent) << "beat " << beat;
  }
  const auto has_the_last = [](Peer& reader) {
    const auto messages = reader.messages();
    const auto newest = messages.empty() ? std::nullopt : msg::decode<msg::ServerInfo>(messages.back());
    return newest && newest->heartbeat() == kBeats;
  };
  EXPECT_TRUE(eventually([&] { return has_the_last(readers.other); }));
  readers.go_on();
  EXPECT_TRUE(eventually([&] { return has_the_last(readers.halted); }));
}

// Fast DDS 2.9 hung for ever in a third of such ends.
TEST_P(HistoryOfPair, ClosesAWriterWhoseReaderLags) {
  for (int round = 0; round < 6; ++round) {
    Peer reader(bus_peer(GetParam().reader, "read", Topic::kStep, "p"));
    const auto bus = open_bus({.vendor = GetParam().writer, .domain = test_domain()});
    const auto writer = bus->writer(Topic::kStep, "p");
    ASSERT_TRUE(eventually([&] { return writer->matched() == 1; }));
    for (std::uint32_t i = 0; i < 8000; ++i) ASSERT_NE(writer->write(numbered(i, 100)), Writer::Result::kFailed);
  }
}

}  // namespace
}  // namespace foothold::interop
