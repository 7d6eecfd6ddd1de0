// The other process of a test: bus_peer VENDOR DOMAIN read|write TOPIC PARTITION [NETWORK_CONFIG].
// read: each message, and each change of matched and living writers, goes to stdout as a frame; ends when stdin does.
// write: tells how many readers are matched, in frames; each frame of stdin goes to the bus, again and again while it is full; at
// the end of stdin waits for acknowledgement.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

#include "foothold/transport/bus.hpp"
#include "frames.hpp"

namespace {

using namespace foothold;
using test::Kind;
using transport::Writer;

transport::Topic topic_named(const std::string& name) {
  for (const transport::TopicTraits& topic : transport::kTopics) {
    if (topic.name == name) return topic.topic;
  }
  throw std::runtime_error("no topic " + name);
}

void read(transport::Bus& bus, transport::Topic topic, const std::string& partition) {
  const auto reader =
      bus.reader(topic, partition,
                 {.on_message = [](std::span<const std::byte> message) { test::put_frame(STDOUT_FILENO, Kind::kMessage, message); },
                  .on_matched = [](std::size_t count) { test::put_number(STDOUT_FILENO, Kind::kMatched, count); },
                  .on_liveliness = [](std::size_t count) { test::put_number(STDOUT_FILENO, Kind::kAlive, count); }});
  test::put_frame(STDOUT_FILENO, Kind::kReady, {});
  while (test::get_frame(STDIN_FILENO)) {
  }
}

int write(transport::Bus& bus, transport::Topic topic, const std::string& partition) {
  const auto writer = bus.writer(topic, partition);
  test::put_frame(STDOUT_FILENO, Kind::kReady, {});
  const std::jthread watching([&](const std::stop_token& stop) {
    for (std::size_t told = 0; !stop.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(2))) {
      const std::size_t matched = writer->matched();
      if (matched != told) test::put_number(STDOUT_FILENO, Kind::kMatched, told = matched);
    }
  });
  while (const auto frame = test::get_frame(STDIN_FILENO)) {
    Writer::Result result = Writer::Result::kFull;
    while ((result = writer->write(frame->octets)) == Writer::Result::kFull)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (result == Writer::Result::kFailed) {
      std::cerr << "bus_peer: " << writer->last_error() << "\n";
      return EXIT_FAILURE;
    }
  }
  return writer->wait_acknowledged(10.0) ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int count, char** words) try {
  if (count < 6) throw std::runtime_error("usage: bus_peer VENDOR DOMAIN read|write TOPIC PARTITION [NETWORK_CONFIG]");
  const auto bus = transport::open_bus({.vendor = words[1],
                                        .domain = static_cast<std::uint32_t>(std::stoul(words[2])),
                                        .network_config = count > 6 ? words[6] : ""});
  const transport::Topic topic = topic_named(words[4]);
  if (std::string(words[3]) == "write") return write(*bus, topic, words[5]);
  read(*bus, topic, words[5]);
  return EXIT_SUCCESS;
} catch (const std::exception& fault) {
  std::cerr << "bus_peer: " << fault.what() << "\n";
  return EXIT_FAILURE;
}
