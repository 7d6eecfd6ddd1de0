// The other process of the raw echo: bench_echo_peer VENDOR DOMAIN echo | sink COUNT. Ends when its stdin does.
#include <atomic>
#include <condition_variable>
#include <deque>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "foothold/transport/bus.hpp"
#include "frames.hpp"
#include "numbered.hpp"

namespace {

using namespace foothold;
using transport::Topic;
using transport::Writer;

constexpr const char* kPartition = "echo";

void until_stdin_ends() {
  while (test::get_frame(STDIN_FILENO)) {
  }
}

// Messages between the listener and the thread that writes.
class Queue {
 public:
  void push(std::span<const std::byte> message) {
    const std::lock_guard lock(mutex_);
    messages_.emplace_back(message.begin(), message.end());
    changed_.notify_one();
  }
  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_one();
  }
  bool pop(std::vector<std::byte>& message) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return ended_ || !messages_.empty(); });
    if (messages_.empty()) return false;
    message = std::move(messages_.front());
    messages_.pop_front();
    return true;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::vector<std::byte>> messages_;
  bool ended_ = false;
};

void echo(transport::Bus& bus) {
  Queue queue;
  const auto writer = bus.writer(Topic::kEvent, kPartition);
  const auto reader =
      bus.reader(Topic::kQuery, kPartition, {.on_message = [&](std::span<const std::byte> message) { queue.push(message); }});
  std::thread answering([&] {
    std::vector<std::byte> message;
    while (queue.pop(message)) {
      while (writer->write(message) == Writer::Result::kFull) std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
  });
  while (reader->matched() == 0 || writer->matched() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  test::put_number(STDOUT_FILENO, test::Kind::kMatched, 2);
  until_stdin_ends();
  queue.end();
  answering.join();
}

// Says so when the last of `count` is there; a gap ends the process.
void sink(transport::Bus& bus, std::uint32_t count) {
  std::uint32_t next = 0;
  const auto reader = bus.reader(Topic::kStep, kPartition,
                                 {.on_message =
                                      [&](std::span<const std::byte> message) {
                                        if (test::number_of(message) != next++) std::abort();
                                        if (next == count) test::put_frame(STDOUT_FILENO, test::Kind::kMessage, message);
                                      },
                                  .on_matched = [](std::size_t n) { test::put_number(STDOUT_FILENO, test::Kind::kMatched, n); }});
  until_stdin_ends();
}

}  // namespace

int main(int words, char** word) try {
  if (words < 4) throw std::runtime_error("usage: bench_echo_peer VENDOR DOMAIN echo | sink COUNT");
  const auto bus = transport::open_bus({.vendor = word[1], .domain = static_cast<std::uint32_t>(std::stoul(word[2]))});
  if (std::string(word[3]) == "echo") {
    echo(*bus);
  } else if (words == 5) {
    sink(*bus, static_cast<std::uint32_t>(std::stoul(word[4])));
  }
  return EXIT_SUCCESS;
} catch (const std::exception& fault) {
  std::cerr << "bench_echo_peer: " << fault.what() << "\n";
  return EXIT_FAILURE;
}
