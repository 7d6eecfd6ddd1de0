// The edge between bus and loop, on a bus in memory: partitions that open, wait, leave out and close; messages in batches.
#include <gtest/gtest.h>

#include <boost/asio/post.hpp>
#include <thread>

#include "fakes.hpp"
#include "memory_bus.hpp"
#include "net/announcer.hpp"
#include "net/inbox.hpp"
#include "net/partitions.hpp"

namespace foothold::server::testing {
namespace {

using transport::Topic;

// Everything that a reader was given.
struct Received {
  std::mutex mutex;
  std::vector<msg::Bytes> messages;
  transport::ReaderEvents events() {
    return {.on_message = [this](std::span<const std::byte> bytes) {
      const std::lock_guard lock(mutex);
      messages.emplace_back(bytes.begin(), bytes.end());
    }};
  }
  std::size_t count() {
    const std::lock_guard lock(mutex);
    return messages.size();
  }
};

class PartitionsTest : public ::testing::Test {
 protected:
  test::MemoryNetwork network_;
  std::unique_ptr<transport::Bus> server_ = network_.bus(), client_ = network_.bus();
  FakeClock clock_;
  bool busy_ = false;
  int wakes_ = 0;
  std::vector<std::string> complaints_;
  Partitions partitions_{*server_,
                         clock_,
                         {.busy = [this](const Id&) { return busy_; },
                          .waiting = [this] { ++wakes_; },
                          .complain = [this](const std::string& text) { complaints_.push_back(text); }}};
};

TEST_F(PartitionsTest, P1EachClientHearsItsOwnPartitionAndAnObserverAll) {
  Received mine, others, all;
  const auto r1 = client_->reader(Topic::kEvent, msg::to_hex(World::kClient), mine.events());
  const auto r2 = client_->reader(Topic::kEvent, msg::to_hex(World::kOther), others.events());
  const auto r3 = client_->reader(Topic::kEvent, "*", all.events());
  partitions_.event(World::kClient, {});
  partitions_.event(World::kClient, {});
  partitions_.event(World::kOther, {});
  ASSERT_TRUE(network_.settle());
  EXPECT_EQ(mine.count(), 2U);
  EXPECT_EQ(others.count(), 1U);
  EXPECT_EQ(all.count(), 3U);
}

TEST_F(PartitionsTest, P1APartitionThatNobodyReadsClosesSooner) {
  Received received;
  auto reader = client_->reader(Topic::kStep, msg::to_hex(World::kClient), received.events());
  for (const Id& client : {World::kClient, World::kOther}) partitions_.open(client);
  ASSERT_TRUE(network_.settle());
  clock_.advance(29);
  partitions_.sweep();
  EXPECT_EQ(partitions_.size(), 2U) << "its reader may be on its way";
  clock_.advance(2);
  partitions_.sweep();
  EXPECT_EQ(partitions_.size(), 1U);
  reader.reset();
  busy_ = true;
  partitions_.sweep();
  EXPECT_EQ(partitions_.size(), 1U);
  busy_ = false;
  partitions_.sweep();
  EXPECT_EQ(partitions_.size(), 0U);
}

TEST_F(PartitionsTest, P1TheQuietestMakesRoomForAnother) {
  const auto client = [](std::size_t i) { return msg::id_of("client " + std::to_string(i)); };
  Received first, last;
  const auto r1 = client_->reader(Topic::kEvent, msg::to_hex(client(0)), first.events());
  const auto r2 = client_->reader(Topic::kEvent, msg::to_hex(client(Partitions::kMost)), last.events());
  for (std::size_t i = 0; i < Partitions::kMost; ++i) {
    partitions_.open(client(i));
    clock_.advance(0.001);
  }
  partitions_.event(client(0), {});  // not the quietest any more
  busy_ = true;
  partitions_.event(client(Partitions::kMost), {});
  EXPECT_EQ(complaints_.size(), 1U);
  busy_ = false;
  partitions_.event(client(Partitions::kMost), {});
  EXPECT_EQ(partitions_.size(), Partitions::kMost);
  partitions_.event(client(0), {});
  ASSERT_TRUE(network_.settle());
  EXPECT_EQ(first.count(), 2U);
  EXPECT_EQ(last.count(), 1U);
  EXPECT_EQ(complaints_.size(), 1U);
}

TEST_F(PartitionsTest, P1AQuietPartitionClosesUnlessItsClientIsBusy) {
  const auto reader = client_->reader(Topic::kEvent, msg::to_hex(World::kClient), {.on_message = [](auto) {}});
  partitions_.open(World::kClient);
  ASSERT_TRUE(network_.settle());
  busy_ = true;
  clock_.advance(301);
  partitions_.sweep();
  EXPECT_EQ(partitions_.size(), 1U);
  busy_ = false;
  partitions_.sweep();
  EXPECT_EQ(partitions_.size(), 0U);
  partitions_.open(World::kClient);
  clock_.advance(299);
  partitions_.sweep();
  EXPECT_EQ(partitions_.size(), 1U) << "opened again, and not quiet for long enough";
}

TEST_F(PartitionsTest, P25WhatAFullWriterDoesNotTakeWaitsAndGoesInOrder) {
  Received received;
  const auto reader = client_->reader(Topic::kStep, msg::to_hex(World::kClient), received.events());
  partitions_.open(World::kClient);
  network_.set_faults(Topic::kStep, {.full = true});
  for (std::uint32_t i = 0; i < 100; ++i) partitions_.step(World::kClient, step_bytes(msg::id_of("r"), i, "s"));
  EXPECT_EQ(wakes_, 1) << "asked for once";
  EXPECT_TRUE(partitions_.waits(World::kClient));
  EXPECT_TRUE(partitions_.waits(World::kClient, msg::id_of("r")));
  EXPECT_FALSE(partitions_.waits(World::kClient, msg::id_of("another")));
  EXPECT_FALSE(partitions_.waits(World::kOther));
  EXPECT_FALSE(partitions_.retry());
  network_.set_faults(Topic::kStep, {});
  EXPECT_TRUE(partitions_.retry());
  EXPECT_FALSE(partitions_.waits(World::kClient, msg::id_of("r")));
  ASSERT_TRUE(network_.settle());
  ASSERT_EQ(received.count(), 100U);
  for (std::uint32_t i = 0; i < 100; ++i) EXPECT_EQ(msg::decode<msg::Step>(received.messages[i])->index(), i);
}

TEST_F(PartitionsTest, P25BeyondTheBoundMessagesAreLeftOutAndThatIsSaid) {
  network_.set_faults(Topic::kStep, {.full = true});
  const auto step = step_bytes(msg::id_of("r"), 0, "s");
  for (std::size_t i = 0; i < Channel::kMostMessages + 5; ++i) partitions_.step(World::kClient, step);
  partitions_.event(World::kOther, {});
  partitions_.sweep();
  ASSERT_EQ(complaints_.size(), 1U);
  EXPECT_NE(complaints_[0].find("5 steps for client " + msg::to_hex(World::kClient)), std::string::npos) << complaints_[0];
  partitions_.sweep();
  EXPECT_EQ(complaints_.size(), 1U) << "said once";
}

class InboxTest : public ::testing::Test {
 protected:
  void run_until(const std::function<bool()>& enough) {
    for (int i = 0; i < 500 && !enough(); ++i) loop_.run_for(std::chrono::milliseconds(10)), loop_.restart();
  }
  test::MemoryNetwork network_;
  std::unique_ptr<transport::Bus> server_ = network_.bus(), client_ = network_.bus();
  boost::asio::io_context loop_{1};
  std::vector<ClientMessage> taken_;
  int batches_ = 0;
  Inbox inbox_{loop_, *server_, [this](ClientMessage message) { taken_.push_back(std::move(message)); }, [this] { ++batches_; }};
};

TEST_F(InboxTest, ABurstIsOneBatchInItsOrder) {
  const auto writer = client_->writer(Topic::kRequest, "");
  for (int i = 0; i < 200; ++i) writer->write(msg::encode(good_request(std::to_string(i))));
  ASSERT_TRUE(network_.settle());
  run_until([&] { return taken_.size() == 200; });
  ASSERT_EQ(taken_.size(), 200U);
  EXPECT_EQ(batches_, 1) << "nothing ran while the burst came";
  for (int i = 0; i < 200; ++i)
    EXPECT_EQ(std::get<msg::PlanRequest>(taken_[static_cast<std::size_t>(i)]), good_request(std::to_string(i)));
}

TEST_F(InboxTest, P9OctetsThatAreNoMessageAreCountedByTopic) {
  const auto requests = client_->writer(Topic::kRequest, "");
  const auto scenes = client_->writer(Topic::kScene, "");
  requests->write(msg::Bytes{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}, std::byte{7}});
  requests->write(msg::Bytes(50, std::byte{0xff}));
  scenes->write(msg::Bytes(7, std::byte{0x01}));
  requests->write(msg::encode(good_request()));
  ASSERT_TRUE(network_.settle());
  run_until([&] { return taken_.size() == 1; });
  EXPECT_EQ(taken_.size(), 1U);
  const std::string complaint = inbox_.take_complaint();
  EXPECT_NE(complaint.find("2 messages on foothold/request"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("1 messages on foothold/scene"), std::string::npos) << complaint;
  EXPECT_EQ(inbox_.take_complaint(), "");
}

TEST(Announcer, SaysARobotAgainOnlyIfItChangedAndBeatsOn) {
  test::MemoryNetwork network;
  const auto server = network.bus();
  const auto client = network.bus();
  Received robots, beats;
  const auto r1 = client->reader(Topic::kRobot, "", robots.events());
  const auto r2 = client->reader(Topic::kServer, "", beats.events());
  Announcer announcer(*server, msg::id_of("server"));
  msg::RobotInfo info;
  info.name("walker");
  const auto ready = std::make_shared<const msg::RobotInfo>(info);
  announcer.robot(ready);
  announcer.robot(ready);
  info.state(msg::QUARANTINED);
  announcer.robot(std::make_shared<const msg::RobotInfo>(info));
  announcer.beat({});
  announcer.beat({});
  ASSERT_TRUE(network.settle());
  ASSERT_EQ(robots.count(), 2U);
  const auto first = *msg::decode<msg::RobotInfo>(robots.messages[0]);
  EXPECT_EQ(first.server(), msg::id_of("server"));
  EXPECT_EQ(first.key(), msg::decode<msg::RobotInfo>(robots.messages[1])->key());
  ASSERT_EQ(beats.count(), 2U);
  EXPECT_EQ(msg::decode<msg::ServerInfo>(beats.messages[1])->heartbeat(), 2U);
}

}  // namespace
}  // namespace foothold::server::testing
