// The raw echo of a vendor pair: what a round trip of the bare bus costs between two processes. Other benches run it in the same
// run as their own measurement, to divide by it. The echo process takes a message in its listener, hands it to another thread, and
// that one writes it back: the least that a server with a loop of its own can do.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "foothold/transport/bus.hpp"
#include "peer.hpp"

namespace foothold::bench {

struct EchoPair {
  std::string client;  // vendor
  std::string server;  // vendor of the echo process
  std::uint32_t domain = 0;
};

class RawEcho {
 public:
  // Starts bin/bench_echo_peer and waits until both ways are matched. Throws std::runtime_error.
  explicit RawEcho(const EchoPair& pair);
  ~RawEcho();
  // Seconds from the write of a message of `size` octets (24 or more) on foothold/query until its echo on foothold/event is in this
  // process's listener's hands and this thread runs again. Throws std::runtime_error after 10 s.
  double round_trip(std::size_t size = 200);

 private:
  void wait_echo(std::uint32_t number);

  std::mutex mutex_;  // of back_
  std::condition_variable changed_;
  std::uint32_t back_ = 0;
  std::uint32_t number_ = 0;
  test::Peer peer_;
  std::unique_ptr<transport::Bus> bus_;
  std::unique_ptr<transport::Reader> reader_;
  std::unique_ptr<transport::Writer> writer_;
};

// Samples per second of `size` octets on foothold/step from this process (pair.client) to the peer (pair.server), until the last of
// `count` is there, none lost.
double throughput(const EchoPair& pair, std::uint32_t count, std::size_t size);

}  // namespace foothold::bench
