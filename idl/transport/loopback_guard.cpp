// Looks at the process's own descriptors: no vendor hands its sockets out.
#include "loopback_guard.hpp"

#include <arpa/inet.h>
#include <dirent.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "foothold/transport/bus.hpp"

namespace foothold::transport {
namespace {

// RTPS 2.3, 9.6.1.1: port base and domain gain.
constexpr std::uint32_t kPortBase = 7400;
constexpr std::uint32_t kDomainGain = 250;

struct OpenSocket {
  int descriptor;
  std::uint64_t inode;
};

struct CloseFolder {
  void operator()(DIR* folder) const { closedir(folder); }
};

std::vector<OpenSocket> open_sockets() {
  std::vector<OpenSocket> sockets;
  const std::unique_ptr<DIR, CloseFolder> folder(opendir("/proc/self/fd"));
  if (!folder) throw BusError("cannot look at /proc/self/fd, so it is not certain that DDS stays on the loopback interface");
  while (const dirent* entry = readdir(folder.get())) {
    if (entry->d_name[0] == '.') continue;
    const int descriptor = std::atoi(entry->d_name);
    struct stat status {};
    if (fstat(descriptor, &status) == 0 && S_ISSOCK(status.st_mode)) sockets.push_back({descriptor, status.st_ino});
  }
  return sockets;
}

struct LocalAddress {
  bool is_udp = false;
  bool is_loopback = false;
  std::uint32_t port = 0;
};

LocalAddress local_address(int descriptor) {
  int type = 0;
  socklen_t size = sizeof type;
  if (getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_DGRAM) return {};
  sockaddr_storage storage{};
  size = sizeof storage;
  if (getsockname(descriptor, reinterpret_cast<sockaddr*>(&storage), &size) != 0) return {};
  if (storage.ss_family == AF_INET) {
    sockaddr_in address{};
    std::memcpy(&address, &storage, sizeof address);
    return {true, address.sin_addr.s_addr == htonl(INADDR_LOOPBACK), ntohs(address.sin_port)};
  }
  if (storage.ss_family == AF_INET6) {
    sockaddr_in6 address{};
    std::memcpy(&address, &storage, sizeof address);
    return {true, false, ntohs(address.sin6_port)};
  }
  return {};
}

}  // namespace

LoopbackGuard::LoopbackGuard(std::uint32_t domain) : domain_(domain) {
  for (const OpenSocket& socket : open_sockets()) before_.insert(socket.inode);
}

void LoopbackGuard::confine() const {
  const std::uint32_t first = kPortBase + kDomainGain * domain_;
  for (const OpenSocket& socket : open_sockets()) {
    if (before_.contains(socket.inode)) continue;
    const LocalAddress address = local_address(socket.descriptor);
    if (!address.is_udp || address.is_loopback || address.port < first || address.port >= first + kDomainGain) continue;
    if (setsockopt(socket.descriptor, SOL_SOCKET, SO_BINDTODEVICE, "lo", sizeof "lo") != 0) {
      throw BusError("cannot keep DDS port " + std::to_string(address.port) +
                     " on the loopback interface: " + std::strerror(errno));
    }
  }
}

}  // namespace foothold::transport
