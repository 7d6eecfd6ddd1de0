// The configuration goes to Cyclone as text, so that the environment (CYCLONEDDS_URI) has no say in it.
#include "domain.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>

#include "loopback_config.hpp"

namespace foothold::transport::cyclone {
namespace {

struct Shared {
  dds_entity_t entity = 0;
  std::string configuration;
  bool secured = false;
  int users = 0;
};

// Plain numbers and text: what they stand for is deleted with the last bus of the domain, not at the program's end.
std::mutex mutex;
std::map<std::uint32_t, Shared>& domains() {
  static std::map<std::uint32_t, Shared> shared;
  return shared;
}

std::string configuration_text(const std::string& network_config) {
  if (network_config.empty()) return kLoopbackConfig;
  std::error_code fault;
  const std::filesystem::path path = std::filesystem::absolute(network_config, fault);
  if (fault || !std::ifstream(path).good()) {
    throw BusError("network_config: cannot read '" + network_config + "'; give the path of a Cyclone DDS configuration file");
  }
  return "file://" + path.string();
}

}  // namespace

BusError error(const std::string& what, dds_return_t code) { return BusError(what + ": Cyclone DDS says " + dds_strretcode(code)); }

Domain::Domain(std::uint32_t id, const std::string& network_config, bool secured) : id_(id) {
  std::string configuration = configuration_text(network_config);
  const std::lock_guard lock(mutex);
  const auto found = domains().find(id);
  if (found != domains().end()) {
    if (found->second.configuration != configuration) {
      throw BusError("domain " + std::to_string(id) + " is open in this process with another network_config");
    }
    // Cyclone 0.10 keeps one set of credentials for all participants of a domain; where two have them, the timers of their
    // handshakes with a participant of Fast DDS end the process (in fibheap_extract_min).
    if (found->second.secured || secured) {
      throw BusError("domain " + std::to_string(id) +
                     " is open in this process already: with security Cyclone DDS takes one bus per domain and process");
    }
    ++found->second.users;
    return;
  }
  const dds_entity_t entity = dds_create_domain(id, configuration.c_str());
  if (entity == DDS_RETCODE_PRECONDITION_NOT_MET) {
    throw BusError("domain " + std::to_string(id) +
                   " was opened in this process by other code, with a configuration that is not known here");
  }
  if (entity < 0) throw error("cannot open domain " + std::to_string(id) + " (is the network configuration sound?)", entity);
  domains().emplace(id, Shared{entity, std::move(configuration), secured, 1});
}

Domain::~Domain() {
  const std::lock_guard lock(mutex);
  const auto found = domains().find(id_);
  if (--found->second.users > 0) return;
  dds_delete(found->second.entity);
  domains().erase(found);
}

}  // namespace foothold::transport::cyclone
