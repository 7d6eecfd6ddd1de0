// Participants that come and go by hand-made packets: no more of them exists than what their announcements say.
#pragma once

#include <netinet/in.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foothold::interop {

// Speaks to the first participant of a domain on 127.0.0.1. Thread rule: one thread. Throws std::runtime_error.
class Departures {
 public:
  explicit Departures(std::uint32_t domain);
  ~Departures();
  Departures(const Departures&) = delete;
  Departures& operator=(const Departures&) = delete;

  // Participant `number` is here, and counts as gone when nothing is heard of it for `lease_ms`.
  void announce(std::uint32_t number, std::uint32_t lease_ms);
  // It says that it leaves.
  void leave(std::uint32_t number);

 private:
  using Octets = std::vector<std::uint8_t>;
  Octets header(std::uint32_t number) const;
  void send(const Octets& packet) const;

  int socket_ = -1;
  sockaddr_in to_{};
  std::uint16_t own_port_ = 0;
};

}  // namespace foothold::interop
