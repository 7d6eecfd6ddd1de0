// RTPS 2.2: messages of the simple participant discovery protocol (9.4, 9.6.2.2), little-endian.
#include "departures.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>

namespace foothold::interop {
namespace {

using Octets = std::vector<std::uint8_t>;

constexpr std::uint8_t kData = 0x15, kLittleEndian = 0x01, kInlineQos = 0x02, kPayload = 0x04;
constexpr std::uint8_t kDetector[4] = {0, 1, 0, 0xc7}, kAnnouncer[4] = {0, 1, 0, 0xc2}, kParticipant[4] = {0, 0, 1, 0xc1};
constexpr std::uint32_t kDiscovery = 0x3f;  // its reader and writers of participants, publications and subscriptions

void put16(Octets& octets, std::uint32_t value) {
  octets.push_back(static_cast<std::uint8_t>(value));
  octets.push_back(static_cast<std::uint8_t>(value >> 8));
}

void put32(Octets& octets, std::uint32_t value) {
  put16(octets, value & 0xffff);
  put16(octets, value >> 16);
}

void put(Octets& octets, const std::uint8_t (&four)[4]) { octets.insert(octets.end(), four, four + 4); }

void put_parameter(Octets& octets, std::uint32_t id, const Octets& value) {
  put16(octets, id);
  put16(octets, static_cast<std::uint32_t>(value.size()));
  octets.insert(octets.end(), value.begin(), value.end());
}

Octets guid_of(const Octets& header) {
  Octets guid(header.begin() + 8, header.begin() + 20);
  put(guid, kParticipant);
  return guid;
}

Octets locator(std::uint16_t port) {
  Octets octets;
  put32(octets, 1);  // UDPv4
  put32(octets, port);
  octets.insert(octets.end(), 12, 0);
  octets.insert(octets.end(), {127, 0, 0, 1});
  return octets;
}

Octets number32(std::uint32_t value) {
  Octets octets;
  put32(octets, value);
  return octets;
}

Octets lease(std::uint32_t ms) {
  Octets octets;
  put32(octets, ms / 1000);
  put32(octets, static_cast<std::uint32_t>((std::uint64_t{ms % 1000} << 32) / 1000));
  return octets;
}

// `what`: inline parameters, or a payload.
void put_data(Octets& packet, std::uint8_t flag, std::uint32_t sequence, const Octets& what) {
  packet.insert(packet.end(), {kData, static_cast<std::uint8_t>(kLittleEndian | flag)});
  put16(packet, static_cast<std::uint32_t>(20 + what.size()));
  put16(packet, 0);
  put16(packet, 16);
  put(packet, kDetector);
  put(packet, kAnnouncer);
  put32(packet, 0);
  put32(packet, sequence);
  packet.insert(packet.end(), what.begin(), what.end());
}

}  // namespace

Departures::Departures(std::uint32_t domain) : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  to_.sin_family = AF_INET;
  to_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  sockaddr_in own = to_;
  to_.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * domain + 10));
  socklen_t size = sizeof own;
  if (socket_ < 0 || ::bind(socket_, reinterpret_cast<const sockaddr*>(&own), size) != 0 ||
      ::getsockname(socket_, reinterpret_cast<sockaddr*>(&own), &size) != 0)
    throw std::runtime_error("no socket");
  own_port_ = ntohs(own.sin_port);
}

Departures::~Departures() { ::close(socket_); }

Departures::Octets Departures::header(std::uint32_t number) const {
  Octets octets{'R', 'T', 'P', 'S', 2, 2, 1, 0x0f, 1, 0x0f};
  octets.insert(octets.end(), 6, 0x5a);
  for (int shift = 24; shift >= 0; shift -= 8) octets.push_back(static_cast<std::uint8_t>(number >> shift));
  return octets;
}

void Departures::announce(std::uint32_t number, std::uint32_t lease_ms) {
  Octets packet = header(number);
  Octets what{0, 3, 0, 0};  // PL_CDR_LE
  put_parameter(what, 0x0015, {2, 2, 0, 0});
  put_parameter(what, 0x0016, {1, 0x0f, 0, 0});
  put_parameter(what, 0x0050, guid_of(packet));
  put_parameter(what, 0x0032, locator(own_port_));
  put_parameter(what, 0x0031, locator(own_port_));
  put_parameter(what, 0x0002, lease(lease_ms));
  put_parameter(what, 0x0058, number32(kDiscovery));
  put_parameter(what, 0x0001, {});
  put_data(packet, kPayload, 1, what);
  send(packet);
}

void Departures::leave(std::uint32_t number) {
  Octets packet = header(number);
  Octets what;
  put_parameter(what, 0x0070, guid_of(packet));
  put_parameter(what, 0x0071, {0, 0, 0, 3});  // disposed and unregistered
  put_parameter(what, 0x0001, {});
  put_data(packet, kInlineQos, 2, what);
  send(packet);
}

void Departures::send(const Octets& packet) const {
  if (::sendto(socket_, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&to_), sizeof to_) < 0)
    throw std::runtime_error("a packet cannot be sent");
}

}  // namespace foothold::interop
