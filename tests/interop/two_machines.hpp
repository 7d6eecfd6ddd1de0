// Two network namespaces joined by a cable: "this machine" (10.99.0.1, where the calling thread and its later children live) and
// "the other machine" (10.99.0.2), which can knock at ports. To see what a program sends and takes beside loopback.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace foothold::interop {

class TwoMachines {
 public:
  // False if this process may not make network namespaces.
  static bool allowed();
  // Precondition: allowed(), the process has one thread. Throws std::runtime_error.
  TwoMachines();
  ~TwoMachines();
  TwoMachines(const TwoMachines&) = delete;
  TwoMachines& operator=(const TwoMachines&) = delete;

  // Packets that left this machine by the cable.
  std::uint64_t packets_out() const;
  // True if the kernel refused a datagram of the other machine to this UDP port: nobody listens there for it.
  bool refuses(std::uint16_t port);
  // UDP ports that are open on this machine, on whatever address.
  static std::vector<std::uint16_t> open_ports();

 private:
  pid_t other_ = -1;
  int ask_ = -1;
  int answer_ = -1;
};

}  // namespace foothold::interop
