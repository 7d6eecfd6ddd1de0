// Ports, socket buffers and shared memory of this host.
#include <algorithm>
#include <charconv>
#include <fstream>
#include <set>
#include <sstream>

#include "check.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

using Level = Finding::Level;

// Ports of the RTPS standard: 7400 + 250 domain, then 10 + 2 for each participant on a host.
constexpr std::uint32_t kPortBase = 7400, kDomainGain = 250, kFirstOffset = 10, kParticipantGain = 2;
// What both vendors' loopback configurations look through.
constexpr std::uint32_t kParticipants = 60;
constexpr std::uint64_t kGoodBuffer = 1 << 20;  // what Cyclone DDS asks for

// Local UDP ports in use, from the kernel's tables: "sl local_address ...", addresses as HEX:PORT.
std::set<std::uint32_t> ports_in_use(const std::filesystem::path& proc) {
  std::set<std::uint32_t> ports;
  for (const char* table : {"net/udp", "net/udp6"}) {
    std::ifstream file(proc / table);
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
      std::istringstream words(line);
      std::string slot, address;
      if (!(words >> slot >> address)) continue;
      const auto colon = address.rfind(':');
      std::uint32_t port = 0;
      if (colon == std::string::npos) continue;
      std::from_chars(address.data() + colon + 1, address.data() + address.size(), port, 16);
      ports.insert(port);
    }
  }
  return ports;
}

}  // namespace

Findings check_participants(const Surroundings& around, const Common& common) {
  const std::uint32_t base = kPortBase + kDomainGain * common.domain;
  const std::set<std::uint32_t> ports = ports_in_use(around.proc);
  std::uint32_t used = 0;
  for (std::uint32_t index = 0; index < kParticipants; ++index)
    if (ports.contains(base + kFirstOffset + kParticipantGain * index)) ++used;
  const std::string count = std::to_string(used) + " of " + std::to_string(kParticipants) + " participants of domain " +
                            std::to_string(common.domain) + " on this host";
  Findings findings;
  if (used >= kParticipants)
    findings.push_back({Level::kFail, "participants", count + ": none is left", "end DDS programs, or use another --domain"});
  else if (used + 5 > kParticipants)
    findings.push_back({Level::kWarn, "participants", count, "end DDS programs, or use another --domain"});
  else
    findings.push_back({Level::kOk, "participants", count, ""});
  std::ifstream range(around.proc / "sys/net/ipv4/ip_local_port_range");
  std::uint32_t low = 0, high = 0;
  if (range >> low >> high && base + kDomainGain > low && base <= high) {
    const std::uint32_t largest = low > kPortBase + kDomainGain ? (low - kPortBase) / kDomainGain - 1 : 0;
    findings.push_back({Level::kWarn, "ports",
                        format("domain %u has UDP ports %u to %u, which the kernel also gives to others (%u to %u)", common.domain,
                               base, base + kDomainGain - 1, low, high),
                        format("use a domain of 0 to %u", largest)});
  }
  return findings;
}

Findings check_socket_buffers(const Surroundings& around) {
  std::ifstream file(around.proc / "sys/net/core/rmem_max");
  std::uint64_t most = 0;
  if (!(file >> most))
    return {{Level::kOk, "socket buffers", "net.core.rmem_max cannot be seen from here (a network namespace of its own)", ""}};
  const std::string value = "net.core.rmem_max is " + std::to_string(most);
  if (most >= kGoodBuffer) return {{Level::kOk, "socket buffers", value, ""}};
  return {{Level::kWarn, "socket buffers",
           value + ", below " + std::to_string(kGoodBuffer) + ": bursts of steps are lost and sent again",
           "sysctl -w net.core.rmem_max=4194304, and the same in /etc/sysctl.d/"}};
}

Findings check_shared_memory(const Surroundings& around) {
  std::uintmax_t octets = 0;
  std::size_t files = 0;
  std::error_code fault;
  for (const auto& entry : std::filesystem::directory_iterator(around.shm, fault)) {
    const std::string name = entry.path().filename().string();
    const bool of_dds = std::ranges::any_of(
        std::initializer_list<const char*>{"fastrtps_", "fastdds_", "sem.fastrtps_", "sem.fastdds_", "iceoryx_"},
        [&](const char* begin) { return name.starts_with(begin); });
    if (!of_dds) continue;
    ++files;
    const auto size = entry.file_size(fault);
    if (!fault) octets += size;
  }
  if (files == 0) return {{Level::kOk, "shared memory", "no files of DDS in " + around.shm.string(), ""}};
  return {{Level::kWarn, "shared memory",
           format("%zu files of DDS in %s, %.1f MB; foothold makes none, others leave them when they are killed", files,
                  around.shm.string().c_str(), static_cast<double>(octets) / 1e6),
           "when no other DDS program runs: rm " + (around.shm / "fastrtps_*").string() + " " +
               (around.shm / "sem.fastrtps_*").string()}};
}

}  // namespace foothold::cli
