// What goes over the loopback interface, and packets put onto it: an attacker who needs no DDS library.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "foothold/msg/ids.hpp"

namespace foothold::test {

using Octets = std::vector<std::uint8_t>;

// A UDP payload that begins as RTPS.
struct Packet {
  std::uint16_t to = 0;  // port
  Octets octets;
  // Of the participant that sent it: RTPS 2.3, 9.4.4.
  std::string sender() const { return {octets.begin() + 8, octets.begin() + 20}; }
  bool holds(const msg::Id& id) const;
};

// Listens from its construction on. Needs CAP_NET_RAW.
class Wiretap {
 public:
  Wiretap();
  ~Wiretap();
  bool works() const { return socket_ >= 0; }
  std::vector<Packet> packets() const;  // so far

 private:
  void listen();
  int socket_ = -1;
  std::atomic<bool> stop_ = false;
  mutable std::mutex mutex_;
  std::vector<Packet> packets_;
  std::thread thread_;
};

// To 127.0.0.1, from whatever port.
void put_on_wire(const Packet& packet);

// Every place where `from` stands is made `to`, of the same length.
Packet replaced(Packet packet, std::span<const std::uint8_t> from, std::span<const std::uint8_t> to);
inline Packet replaced(Packet packet, const std::string& from, const std::string& to) {
  return replaced(std::move(packet), std::span(reinterpret_cast<const std::uint8_t*>(from.data()), from.size()),
                  std::span(reinterpret_cast<const std::uint8_t*>(to.data()), to.size()));
}

// The sequence number of the last DATA submessage (in clear text) that holds this id; and the packet with another one there.
std::optional<std::uint32_t> sequence_number(const Packet& packet, const msg::Id& id);
Packet renumbered(Packet packet, const msg::Id& id, std::uint32_t number);

// Where the octets are that DDS Security has enciphered or signed (its submessages' bodies): first and behind the last.
std::vector<std::pair<std::size_t, std::size_t>> protected_parts(const Packet& packet);

}  // namespace foothold::test
