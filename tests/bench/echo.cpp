// The client's side of the raw echo and of the throughput measurement.
#include "echo.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "numbered.hpp"

namespace foothold::bench {
namespace {

using transport::Topic;
using transport::Writer;
using Clock = std::chrono::steady_clock;

constexpr const char* kPartition = "echo";

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void write_on(Writer& writer, std::span<const std::byte> message) {
  const auto begin = Clock::now();
  Writer::Result result = Writer::Result::kFull;
  while ((result = writer.write(message)) == Writer::Result::kFull) {
    if (seconds_since(begin) > 10.0) throw std::runtime_error("the writer stays full");
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  if (result == Writer::Result::kFailed) throw std::runtime_error("write: " + writer.last_error());
}

void wait_matched(const transport::Reader& reader, const Writer& writer) {
  const auto begin = Clock::now();
  while (reader.matched() == 0 || writer.matched() == 0) {
    if (seconds_since(begin) > 20.0) throw std::runtime_error("the echo process was not found");
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace

RawEcho::RawEcho(const EchoPair& pair)
    : peer_({"bench_echo_peer", pair.server, std::to_string(pair.domain), "echo"}),
      bus_(transport::open_bus({.vendor = pair.client, .domain = pair.domain})),
      reader_(bus_->reader(Topic::kEvent, kPartition,
                           {.on_message =
                                [this](std::span<const std::byte> message) {
                                  const std::lock_guard lock(mutex_);
                                  back_ = test::number_of(message);
                                  changed_.notify_one();
                                }})),
      writer_(bus_->writer(Topic::kQuery, kPartition)) {
  wait_matched(*reader_, *writer_);
  if (!peer_.wait_number(test::Kind::kMatched, 2)) throw std::runtime_error("the echo process has found nobody");
}

RawEcho::~RawEcho() = default;

double RawEcho::round_trip(std::size_t size) {
  const auto message = test::numbered(++number_, size);
  const auto begin = Clock::now();
  write_on(*writer_, message);
  std::unique_lock lock(mutex_);
  if (!changed_.wait_for(lock, std::chrono::seconds(10), [&] { return back_ == number_; })) throw std::runtime_error("no echo");
  return seconds_since(begin);
}

double throughput(const EchoPair& pair, std::uint32_t count, std::size_t size) {
  test::Peer peer({"bench_echo_peer", pair.server, std::to_string(pair.domain), "sink", std::to_string(count)});
  const auto bus = transport::open_bus({.vendor = pair.client, .domain = pair.domain});
  const auto writer = bus->writer(Topic::kStep, kPartition);
  if (!peer.wait_number(test::Kind::kMatched, 1)) throw std::runtime_error("the sink has found nobody");
  while (writer->matched() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  const auto begin = Clock::now();
  for (std::uint32_t i = 0; i < count; ++i) write_on(*writer, test::numbered(i, size));
  if (!peer.wait_messages(1, 120.0)) throw std::runtime_error("the sink did not get all");
  return count / seconds_since(begin);
}

}  // namespace foothold::bench
