// See wiretap.hpp. RTPS 2.3, 8.3.3 and 9.4.5: a header of 20 octets, then submessages; of DATA the sequence number is at 16.
#include "wiretap.hpp"

#include <arpa/inet.h>
#include <linux/if_ether.h>
#include <linux/if_packet.h>
#include <net/if.h>
#include <netinet/ip.h>
#include <netinet/udp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace foothold::test {
namespace {

constexpr std::size_t kHeader = 20;
constexpr std::uint8_t kData = 0x15;
// DDS Security 1.1, 7.3.7.2: SEC_BODY to SRTPS_POSTFIX.
constexpr std::uint8_t kFirstProtected = 0x30, kLastProtected = 0x34;
constexpr std::size_t kNumber = 20;  // of the lower half, from the submessage's begin

bool is_rtps(std::span<const std::uint8_t> octets) { return octets.size() > kHeader && std::memcmp(octets.data(), "RTPS", 4) == 0; }

struct Submessage {
  std::size_t begin, end;  // the header of 4 octets included
};

std::vector<Submessage> submessages(const Packet& packet) {
  const Octets& all = packet.octets;
  std::vector<Submessage> found;
  for (std::size_t at = kHeader; at + 4 <= all.size();) {
    const bool little = (all[at + 1] & 1U) != 0;
    std::size_t length = little ? all[at + 2] | all[at + 3] << 8U : all[at + 2] << 8U | all[at + 3];
    if (length == 0 || at + 4 + length > all.size()) length = all.size() - at - 4;  // 0: up to the packet's end
    found.push_back({at, at + 4 + length});
    at += 4 + length;
  }
  return found;
}

// Where the last DATA that holds the id begins.
std::optional<std::size_t> data_with(const Packet& packet, const msg::Id& id) {
  const Octets& all = packet.octets;
  std::optional<std::size_t> found;
  for (const Submessage& each : submessages(packet)) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(each.begin),
               end = all.begin() + static_cast<std::ptrdiff_t>(each.end);
    const bool little = (all[each.begin + 1] & 1U) != 0;
    if (all[each.begin] == kData && little && std::search(begin, end, id.begin(), id.end()) != end) found = each.begin;
  }
  return found;
}

}  // namespace

bool Packet::holds(const msg::Id& id) const {
  return std::search(octets.begin(), octets.end(), id.begin(), id.end()) != octets.end();
}

Wiretap::Wiretap() : socket_(::socket(AF_PACKET, SOCK_DGRAM | SOCK_CLOEXEC, htons(ETH_P_IP))) {
  if (socket_ < 0) return;
  const int room = 64 << 20;
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUFFORCE, &room, sizeof room);
  sockaddr_ll address{};
  address.sll_family = AF_PACKET;
  address.sll_protocol = htons(ETH_P_IP);
  address.sll_ifindex = static_cast<int>(::if_nametoindex("lo"));
  if (::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    ::close(socket_);
    socket_ = -1;
    return;
  }
  thread_ = std::thread([this] { listen(); });
}

Wiretap::~Wiretap() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
  if (socket_ >= 0) ::close(socket_);
}

void Wiretap::listen() {
  Octets buffer(1 << 16);
  while (!stop_) {
    pollfd ready{socket_, POLLIN, 0};
    if (::poll(&ready, 1, 50) <= 0) continue;
    sockaddr_ll from{};
    socklen_t size = sizeof from;
    const ssize_t got = ::recvfrom(socket_, buffer.data(), buffer.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
    // Bound to one protocol, a socket hears each packet once, as it comes.
    if (got <= 0 || from.sll_pkttype != PACKET_HOST) continue;
    const std::span<const std::uint8_t> all(buffer.data(), static_cast<std::size_t>(got));
    if (all.size() < sizeof(ip)) continue;
    ip header{};
    std::memcpy(&header, all.data(), sizeof header);
    const std::size_t begin = std::size_t{header.ip_hl} * 4 + sizeof(udphdr);
    if (header.ip_p != IPPROTO_UDP || all.size() <= begin) continue;
    udphdr datagram{};
    std::memcpy(&datagram, all.data() + begin - sizeof datagram, sizeof datagram);
    if (!is_rtps(all.subspan(begin))) continue;
    const std::lock_guard lock(mutex_);
    packets_.push_back({ntohs(datagram.uh_dport), Octets(all.begin() + static_cast<std::ptrdiff_t>(begin), all.end())});
  }
}

std::vector<Packet> Wiretap::packets() const {
  const std::lock_guard lock(mutex_);
  return packets_;
}

void put_on_wire(const Packet& packet) {
  static const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  to.sin_port = htons(packet.to);
  // A port that nobody has any more answers with an error at the next call: no matter.
  [[maybe_unused]] const ssize_t sent =
      ::sendto(socket, packet.octets.data(), packet.octets.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
}

Packet replaced(Packet packet, std::span<const std::uint8_t> from, std::span<const std::uint8_t> to) {
  for (auto at = packet.octets.begin();;) {
    at = std::search(at, packet.octets.end(), from.begin(), from.end());
    if (at == packet.octets.end()) return packet;
    at = std::copy(to.begin(), to.end(), at);
  }
}

std::optional<std::uint32_t> sequence_number(const Packet& packet, const msg::Id& id) {
  const auto at = data_with(packet, id);
  if (!at) return std::nullopt;
  std::uint32_t number = 0;
  std::memcpy(&number, packet.octets.data() + *at + kNumber, sizeof number);
  return number;
}

Packet renumbered(Packet packet, const msg::Id& id, std::uint32_t number) {
  const auto at = data_with(packet, id);
  if (!at) throw std::invalid_argument("no DATA holds that id");
  std::memcpy(packet.octets.data() + *at + kNumber, &number, sizeof number);
  return packet;
}

std::vector<std::pair<std::size_t, std::size_t>> protected_parts(const Packet& packet) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (const Submessage& each : submessages(packet)) {
    const std::uint8_t kind = packet.octets[each.begin];
    if (kind >= kFirstProtected && kind <= kLastProtected && each.end > each.begin + 4)
      found.emplace_back(each.begin + 4, each.end);
  }
  return found;
}

}  // namespace foothold::test
