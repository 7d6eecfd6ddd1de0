// The worker's end of the socket pair, and who reads it while a plan runs.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>

#include "worker/channel.hpp"
#include "worker/stop_watch.hpp"

namespace foothold::server {
namespace {

using namespace std::chrono_literals;

class Channels : public ::testing::Test {
 protected:
  Channels() { EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, sockets_), 0); }
  ~Channels() override {
    close(sockets_[0]);
    if (sockets_[1] >= 0) close(sockets_[1]);
  }
  void daemon_sends(frame::WorkerFrame kind, std::uint64_t run) {
    msg::Bytes frame;
    seal_frame(kind, run, frame);
    EXPECT_EQ(::send(sockets_[1], frame.data(), frame.size(), 0), static_cast<ssize_t>(frame.size()));
  }
  void daemon_leaves() {
    close(sockets_[1]);
    sockets_[1] = -1;
  }
  static bool becomes_true(const std::function<bool()>& condition) {
    for (int i = 0; i < 2000 && !condition(); ++i) std::this_thread::sleep_for(5ms);
    return condition();
  }
  int sockets_[2] = {-1, -1};
};

TEST_F(Channels, GiveFramesUntilTheDaemonLeaves) {
  Channel channel(sockets_[0]);
  daemon_sends(frame::STOP, 7);
  daemon_leaves();
  const auto frame = channel.read();
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->kind, frame::STOP);
  EXPECT_EQ(frame->run, 7u);
  EXPECT_FALSE(channel.read().has_value());
  EXPECT_TRUE(channel.ended());
}

TEST_F(Channels, TakingDoesNotWait) {
  Channel channel(sockets_[0]);
  EXPECT_FALSE(channel.take().has_value());
  EXPECT_FALSE(channel.ended());
}

TEST_F(Channels, SendingToADaemonThatLeftThrows) {
  Channel channel(sockets_[0]);
  daemon_leaves();
  EXPECT_THROW(channel.send(frame::REFUSED, 0, frame::Refused{}), ChannelClosed);
}

TEST_F(Channels, StopOfTheRunSetsItsToken) {
  Channel channel(sockets_[0]);
  StopWatch watch(channel);
  std::stop_source source;
  watch.begin(5, source);
  daemon_sends(frame::STOP, 4);
  daemon_sends(frame::STOP, 5);
  EXPECT_TRUE(becomes_true([&] { return source.stop_requested(); }));
  watch.end();
}

TEST_F(Channels, StopOfAnotherRunDoesNot) {
  Channel channel(sockets_[0]);
  StopWatch watch(channel);
  std::stop_source source;
  watch.begin(5, source);
  daemon_sends(frame::STOP, 4);
  std::this_thread::sleep_for(50ms);
  EXPECT_FALSE(source.stop_requested());
  watch.end();
}

TEST_F(Channels, ADaemonThatLeavesStopsTheRun) {
  Channel channel(sockets_[0]);
  StopWatch watch(channel);
  std::stop_source source;
  watch.begin(5, source);
  daemon_leaves();
  EXPECT_TRUE(becomes_true([&] { return source.stop_requested(); }));
  watch.end();
}

// The next frame after a run must always be the main thread's, whether the run was watched yet or not.
TEST_F(Channels, AfterEachRunTheChannelIsTheMainThreadsAgain) {
  Channel channel(sockets_[0]);
  StopWatch watch(channel);
  for (std::uint64_t run = 1; run <= 300; ++run) {
    std::stop_source source;
    watch.begin(run, source);
    if (run % 3 == 0) std::this_thread::sleep_for(1ms + std::chrono::microseconds(run));
    const bool stop = run % 2 == 0;
    if (stop) {
      daemon_sends(frame::STOP, run);
      ASSERT_TRUE(becomes_true([&] { return source.stop_requested(); })) << run;
    }
    watch.end();
    daemon_sends(frame::PLAN, run + 1);
    const auto frame = channel.read();
    ASSERT_TRUE(frame.has_value());
    EXPECT_EQ(frame->kind, frame::PLAN);
    EXPECT_EQ(frame->run, run + 1);
  }
}

}  // namespace
}  // namespace foothold::server
