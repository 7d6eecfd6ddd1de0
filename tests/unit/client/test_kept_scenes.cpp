// Files that a client uploaded, for servers that come later: to whom they go, and to whom not. P40.
#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <span>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/errors.hpp"
#include "kept_scenes.hpp"
#include "memory_bus.hpp"

namespace foothold::test {
namespace {

using client::KeptScenes;

class KeptScenesTest : public testing::Test {
 protected:
  KeptScenesTest() {
    reader_ = server_bus_->reader(transport::Topic::kScene, "", {.on_message = [this](std::span<const std::byte> octets) {
                                    const std::lock_guard lock(mutex_);
                                    chunks_.push_back(msg::decode<msg::SceneChunk>(octets).value());
                                  }});
  }

  static msg::SceneChunk label(const std::string& name, const std::string& revision) {
    msg::SceneChunk chunk;
    chunk.name(name);
    chunk.format("yaml");
    chunk.revision(revision);
    return chunk;
  }
  void keep(const std::string& name, const std::string& revision, std::size_t size) {
    auto chunk = label(name, revision);
    chunk.size(size);
    scenes_.keep(chunk, std::vector<std::byte>(size, std::byte{7}));
  }
  void comes(const std::string& server) {
    msg::ServerInfo info;
    info.key(msg::id_of(server));
    directory_.add(info, now_);
    msg::RobotInfo robot;
    robot.key(msg::id_of(server + " robot"));
    robot.server(msg::id_of(server));
    robot.name("robot");
    directory_.add(robot);
  }
  void tells(const std::string& server, const std::string& name, const std::string& revision, std::int64_t stamp,
             msg::SceneState state = msg::STORED, const msg::Id& upload = msg::kNoId) {
    msg::SceneStatus status;
    status.key(msg::id_of(server + name + revision));
    status.server(msg::id_of(server));
    status.name(name);
    status.revision(revision);
    status.stamp(stamp);
    status.state(state);
    status.upload(upload);
    directory_.add(status);
  }
  void tend(double seconds) {
    now_ += std::chrono::milliseconds(static_cast<int>(1e3 * seconds));
    while (scenes_.tend(now_)) ASSERT_TRUE(network_.settle());
    ASSERT_TRUE(network_.settle());
  }
  std::vector<msg::SceneChunk> sent_to(const std::string& server) {
    const std::lock_guard lock(mutex_);
    std::vector<msg::SceneChunk> found;
    for (const auto& chunk : chunks_)
      if (chunk.server() == msg::id_of(server)) found.push_back(chunk);
    return found;
  }
  bool may_deliver(const std::string& revision = {}, std::vector<msg::Id> except = {}) {
    msg::PlanRequest request;
    request.robot("robot");
    request.scene("yard");
    request.scene_revision(revision);
    return scenes_.may_deliver(request, except);
  }

  MemoryNetwork network_;
  std::unique_ptr<transport::Bus> server_bus_ = network_.bus(), client_bus_ = network_.bus();
  std::mutex mutex_;
  std::vector<msg::SceneChunk> chunks_;
  client::Directory directory_{msg::id_of("client")};
  client::Outgoing outgoing_{*client_bus_};
  KeptScenes scenes_{directory_, outgoing_, 1 << 20};
  KeptScenes::Clock::time_point now_ = KeptScenes::Clock::now();
  std::unique_ptr<transport::Reader> reader_;
};

TEST_F(KeptScenesTest, GoWholeToAServerThatHasNoneOfThatName) {
  keep("yard", "a", 200000);
  comes("has it");
  tells("has it", "yard", "a", 1);
  comes("new");
  EXPECT_TRUE(may_deliver());
  EXPECT_TRUE(may_deliver("a"));
  EXPECT_FALSE(may_deliver("b"));
  EXPECT_FALSE(may_deliver({}, {msg::id_of("new")})) << "nobody else lacks it";
  tend(0.5);
  EXPECT_TRUE(sent_to("new").empty()) << "it may still tell of what it has";
  tend(0.6);
  const auto chunks = sent_to("new");
  std::size_t octets = 0;
  for (const auto& chunk : chunks) {
    EXPECT_EQ(chunk.offset(), octets);
    EXPECT_EQ(chunk.name() + chunk.format() + chunk.revision(), "yardyamla");
    EXPECT_EQ(chunk.size(), 200000U);
    octets += chunk.data().size();
  }
  EXPECT_EQ(octets, 200000U);
  EXPECT_TRUE(sent_to("has it").empty());
  tells("new", "yard", "a", 2, msg::STORED, chunks.front().upload());
  tend(60.0);
  EXPECT_EQ(sent_to("new").size(), chunks.size()) << "once";
  EXPECT_FALSE(may_deliver());
}

TEST_F(KeptScenesTest, WhatWasSupersededIsNotSpread) {
  keep("yard", "a", 10);
  comes("one");
  tells("one", "yard", "a", 1);
  comes("another");
  tells("another", "yard", "b", 2);
  comes("new");
  tend(2.0);
  EXPECT_TRUE(sent_to("new").empty());
  EXPECT_TRUE(sent_to("another").empty());
  EXPECT_FALSE(may_deliver());
  keep("yard", "b", 10);
  tend(0.1);
  ASSERT_EQ(sent_to("new").size(), 1U);
  EXPECT_EQ(sent_to("new").front().revision(), "b");
}

TEST_F(KeptScenesTest, ARefusalStays) {
  keep("yard", "a", 10);
  comes("new");
  tend(2.0);
  ASSERT_EQ(sent_to("new").size(), 1U);
  EXPECT_TRUE(may_deliver());
  tells("new", "yard", "a", 1, msg::REFUSED, sent_to("new").front().upload());
  tend(0.1);
  EXPECT_FALSE(may_deliver());
  tend(60.0);
  EXPECT_EQ(sent_to("new").size(), 1U);
}

TEST_F(KeptScenesTest, WithoutAVerdictItIsTriedThreeTimes) {
  keep("yard", "a", 10);
  comes("new");
  tend(2.0);
  for (int i = 0; i < 10; ++i) tend(11.0);
  EXPECT_EQ(sent_to("new").size(), 3U);
  EXPECT_FALSE(may_deliver());
}

TEST_F(KeptScenesTest, BeyondTheBoundTheFirstGoes) {
  keep("yard", "a", 600000);
  keep("too large", "c", (1 << 20) + 1);
  keep("garden", "b", 600000);
  comes("new");
  EXPECT_FALSE(may_deliver());
  tend(2.0);
  for (const auto& chunk : sent_to("new")) EXPECT_EQ(chunk.name(), "garden");
  EXPECT_EQ(sent_to("new").size(), 10U);
}

}  // namespace
}  // namespace foothold::test
