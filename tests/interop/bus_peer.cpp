// The other process of a test: bus_peer VENDOR DOMAIN read|decode|write TOPIC PARTITION [NETWORK_CONFIG].
// read: each message, and each change of matched and living writers, goes to stdout as a frame; ends when stdin does.
// decode: like read, but instead of a message one octet: 1 if it is a message of the topic's type, else 0.
// write: tells how many readers are matched, in frames; each frame of stdin goes to the bus, again and again while it is full; at
// the end of stdin waits for acknowledgement.
#include <foothold.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

#include "foothold/msg/cdr.hpp"
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

bool decodes(transport::Topic topic, std::span<const std::byte> message) {
  using transport::Topic;
  switch (topic) {
    case Topic::kRequest:
      return msg::decode<msg::PlanRequest>(message).has_value();
    case Topic::kCancel:
      return msg::decode<msg::CancelRequest>(message).has_value();
    case Topic::kQuery:
      return msg::decode<msg::StateQuery>(message).has_value();
    case Topic::kEvent:
      return msg::decode<msg::PlanEvent>(message).has_value();
    case Topic::kStep:
      return msg::decode<msg::Step>(message).has_value();
    case Topic::kScene:
      return msg::decode<msg::SceneChunk>(message).has_value();
    case Topic::kSceneStatus:
      return msg::decode<msg::SceneStatus>(message).has_value();
    case Topic::kRobot:
      return msg::decode<msg::RobotInfo>(message).has_value();
    case Topic::kServer:
      return msg::decode<msg::ServerInfo>(message).has_value();
  }
  return false;
}

void read(transport::Bus& bus, transport::Topic topic, const std::string& partition, bool decoding) {
  const auto on_message = [topic, decoding](std::span<const std::byte> message) {
    const auto verdict = std::byte{decoding && decodes(topic, message)};
    test::put_frame(STDOUT_FILENO, Kind::kMessage, decoding ? std::span(&verdict, 1) : message);
  };
  const auto reader =
      bus.reader(topic, partition,
                 {.on_message = on_message,
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
  if (count < 6) throw std::runtime_error("usage: bus_peer VENDOR DOMAIN read|decode|write TOPIC PARTITION [NETWORK_CONFIG]");
  const auto bus = transport::open_bus({.vendor = words[1],
                                        .domain = static_cast<std::uint32_t>(std::stoul(words[2])),
                                        .network_config = count > 6 ? words[6] : ""});
  const transport::Topic topic = topic_named(words[4]);
  if (std::string(words[3]) == "write") return write(*bus, topic, words[5]);
  read(*bus, topic, words[5], std::string(words[3]) == "decode");
  return EXIT_SUCCESS;
} catch (const std::exception& fault) {
  std::cerr << "bus_peer: " << fault.what() << "\n";
  return EXIT_FAILURE;
}
