// The loopback configuration is set here, not by XML: what the environment names (FASTRTPS_DEFAULT_PROFILES_FILE) is loaded by Fast
// DDS, but a participant whose settings are given in full takes nothing from it.
#include "participant.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>

#include "security.hpp"

namespace foothold::transport::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::types::ReturnCode_t;

constexpr const char* kLoopback = "127.0.0.1";
constexpr const char* kProfile = "foothold";
// Above the number of DDS programs of both vendors on one host.
constexpr std::uint32_t kParticipantsPerHost = 60;
// Octets, or what the kernel allows (net.core.rmem_max): a burst waits here until its reader comes to run.
constexpr std::uint32_t kSocketBuffer = 4U << 20U;
// Of whom nothing was heard for so long he is gone (the same in Cyclone's configuration). Longer than a process or a machine stands
// still at times: where one side takes the other for gone and not the other way round, Fast DDS 2.9 does not send again what the
// other had, and the two never hear each other again. That a server is gone is noticed by its heartbeats, not by this.
const eprosima::fastrtps::Duration_t kLease(20, 0);
// Octets after which a writer asks for acknowledgement along with a sample.
constexpr std::uint32_t kSendBuffer = 64U << 10U;

rtps::Locator_t loopback_locator() {
  rtps::Locator_t locator;
  rtps::IPLocator::setIPv4(locator, kLoopback);
  return locator;
}

dds::DomainParticipantQos loopback_qos() {
  dds::DomainParticipantQos qos;
  const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {kLoopback};
  udp->maxInitialPeersRange = kParticipantsPerHost;
  udp->receiveBufferSize = kSocketBuffer;
  udp->sendBufferSize = kSendBuffer;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports = {udp};
  auto& builtin = qos.wire_protocol().builtin;
  builtin.discovery_config.leaseDuration = kLease;
  builtin.discovery_config.leaseDuration_announcementperiod = {1, 0};
  builtin.metatrafficUnicastLocatorList.push_back(loopback_locator());
  builtin.initialPeersList.push_back(loopback_locator());
  return qos;
}

// Fast DDS keeps profiles for the whole process and by name, so a second file cannot give another "foothold".
dds::DomainParticipantQos profile_qos(const std::string& network_config) {
  static std::mutex mutex;
  static std::string loaded;
  const std::lock_guard lock(mutex);
  auto& factory = *dds::DomainParticipantFactory::get_instance();
  dds::DomainParticipantQos qos;
  std::error_code fault;
  const std::string path = std::filesystem::absolute(network_config, fault).string();
  if (fault || !std::ifstream(path).good()) {
    throw BusError("network_config: cannot read '" + network_config + "'; give the path of a Fast DDS profiles file");
  }
  if (loaded.empty()) {
    if (factory.get_participant_qos_from_profile(kProfile, qos) == ReturnCode_t::RETCODE_OK) {
      throw BusError(
          "network_config: a profile 'foothold' is already loaded, from FASTRTPS_DEFAULT_PROFILES_FILE or by other code");
    }
    if (factory.load_XML_profiles_file(path) != ReturnCode_t::RETCODE_OK) {
      throw BusError("network_config: Fast DDS refuses '" + path + "' (its log on stderr names the line)");
    }
    loaded = path;
  }
  if (loaded != path) {
    throw BusError("network_config: '" + loaded + "' is in use in this process; a process takes one file of Fast DDS profiles");
  }
  if (factory.get_participant_qos_from_profile(kProfile, qos) != ReturnCode_t::RETCODE_OK) {
    throw BusError("network_config: '" + path + "' has no participant with profile_name=\"foothold\"");
  }
  return qos;
}

// These change a participant's discovery whatever its settings say.
void refuse_overriding_environment() {
  for (const char* name : {"ROS_DISCOVERY_SERVER", "FASTDDS_ENVIRONMENT_FILE"}) {
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0') {
      throw BusError(std::string(name) + " is set and would override the network configuration of Fast DDS; unset it");
    }
  }
}

// Deliver by the transport within a process too: direct delivery would run a reader's callbacks inside the writer's write().
void deliver_by_transport() {
  eprosima::fastrtps::LibrarySettingsAttributes settings;
  settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
}

}  // namespace

Participant::Participant(const BusOptions& options) {
  refuse_overriding_environment();
  auto& factory = *dds::DomainParticipantFactory::get_instance();
  factory.load_profiles();
  deliver_by_transport();
  dds::DomainParticipantQos qos = options.network_config.empty() ? loopback_qos() : profile_qos(options.network_config);
  if (!options.security.empty()) secure(qos, options.security);
  const LoopbackGuard guard(options.domain);
  participant_ = factory.create_participant(options.domain, qos, &departures_, dds::StatusMask::none());
  if (participant_ == nullptr) {
    throw BusError("cannot make a participant of Fast DDS in domain " + std::to_string(options.domain) +
                   " (is the network configuration sound? its log on stderr may say more)");
  }
  if (options.network_config.empty()) confine(guard);
}

void Participant::confine(const LoopbackGuard& guard) try { guard.confine(); } catch (const BusError&) {
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  throw;
}

Participant::~Participant() {
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

}  // namespace foothold::transport::fastdds
