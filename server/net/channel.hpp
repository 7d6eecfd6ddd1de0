// One writer of a client's partition, with the bounded queue that stands before it when its reader is slow (idl/PROTOCOL.md P25).
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/ids.hpp"
#include "foothold/transport/bus.hpp"

namespace foothold::server {

// Thread rule: the loop.
class Channel {
 public:
  // How much may wait before messages are left out.
  static constexpr std::size_t kMostMessages = 20000;
  static constexpr std::size_t kMostOctets = 32u << 20;

  explicit Channel(std::unique_ptr<transport::Writer> writer) : writer_(std::move(writer)) {}

  // Writes at once, or behind what waits already, or leaves it out.
  void send(std::span<const std::byte> message);
  // Writes what waits, as far as the writer takes it. True if nothing waits any more.
  bool retry();
  bool waits() const { return !waiting_.empty(); }
  bool waits_of(const msg::Id& request) const { return waiting_of_.contains(request); }
  // Messages left out since the last call, because too much waited or the writer failed; `why` in words.
  std::uint64_t take_left_out(std::string& why);
  transport::Writer& writer() const { return *writer_; }

 private:
  // False if the writer is full.
  bool write(std::span<const std::byte> message);

  std::unique_ptr<transport::Writer> writer_;
  std::deque<msg::Bytes> waiting_;
  std::size_t waiting_octets_ = 0;
  std::unordered_map<msg::Id, std::size_t, msg::IdHash> waiting_of_;  // messages, by request
  std::uint64_t left_out_ = 0;
  std::string why_;
};

}  // namespace foothold::server
