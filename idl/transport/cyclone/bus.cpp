// Participant and topics, and the function by which open_bus() finds this library.
#include "bus.hpp"

#include <dds/version.h>

#include "../loopback_guard.hpp"
#include "security.hpp"

namespace foothold::transport::cyclone {

Entity::Entity(dds_entity_t handle, const std::string& what) : handle_(handle) {
  if (handle < 0) throw error("cannot make " + what, handle);
}

Entity& Entity::operator=(Entity&& other) noexcept {
  std::swap(handle_, other.handle_);
  return *this;
}

Entity::~Entity() {
  if (handle_ > 0) dds_delete(handle_);
}

CycloneBus::CycloneBus(const BusOptions& options) {
  const LoopbackGuard guard(options.domain);
  domain_.emplace(options.domain, options.network_config, !options.security.empty());
  const Qos qos = participant_qos(options.security);
  participant_ = Entity(dds_create_participant(options.domain, qos.get(), nullptr),
                        "a participant in domain " + std::to_string(options.domain) +
                            " (more DDS programs on this host than MaxAutoParticipantIndex allows?)");
  if (options.network_config.empty()) guard.confine();
}

const BytesTopic& CycloneBus::topic_of(Topic topic) {
  const std::lock_guard lock(mutex_);
  BytesTopic& found = topics_[static_cast<std::size_t>(topic)];
  if (found.entity) return found;
  const TopicTraits& wanted = traits(topic);
  ddsi_sertype* type = new_bytes_type(wanted);
  const std::string name(wanted.name);
  const dds_entity_t handle = dds_create_topic_sertype(participant_.get(), name.c_str(), &type, nullptr, nullptr, nullptr);
  if (handle < 0) ddsi_sertype_unref(type);
  found.entity = Entity(handle, "topic " + name);
  found.type = type;
  return found;
}

std::unique_ptr<Writer> CycloneBus::writer(Topic topic, const std::string& partition) {
  return make_writer(participant_.get(), topic_of(topic), traits(topic), partition);
}

std::unique_ptr<Reader> CycloneBus::reader(Topic topic, const std::string& partition, ReaderEvents events) {
  return make_reader(participant_.get(), topic_of(topic), traits(topic), partition, std::move(events));
}

std::string CycloneBus::version() const { return DDS_VERSION; }

}  // namespace foothold::transport::cyclone

FOOTHOLD_BUS_ENTRY(const foothold::transport::BusOptions& options) { return new foothold::transport::cyclone::CycloneBus(options); }
