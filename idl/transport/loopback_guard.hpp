// Keeps a bus on the loopback interface whatever its vendor does. Cyclone DDS receives on 0.0.0.0 even when it is configured for
// 127.0.0.1 alone: what other machines send would reach it, so its sockets are bound to the device `lo`.
#pragma once

#include <cstdint>
#include <set>

namespace foothold::transport {

// Make one before the vendor opens its sockets, call confine() when they are open. Any thread.
class LoopbackGuard {
 public:
  explicit LoopbackGuard(std::uint32_t domain);
  // Binds every UDP socket of this process that was made since, on a port of the domain, to `lo`, unless its address is 127.0.0.1.
  // Throws BusError if the kernel refuses.
  void confine() const;

 private:
  std::uint32_t domain_;
  std::set<std::uint64_t> before_;  // inodes of sockets
};

}  // namespace foothold::transport
