// Participant and topics, and the function by which open_bus() finds this library.
#include "bus.hpp"

#include <fastdds/dds/topic/TypeSupport.hpp>

#include "bytes_type.hpp"

namespace foothold::transport::fastdds {

namespace dds = eprosima::fastdds::dds;

FastBus::FastBus(const BusOptions& options) : participant_(options) {}

dds::Topic& FastBus::topic_of(Topic topic) {
  const std::lock_guard lock(mutex_);
  dds::Topic*& found = topics_[static_cast<std::size_t>(topic)];
  if (found != nullptr) return *found;
  const TopicTraits& wanted = traits(topic);
  dds::TypeSupport(new BytesType(wanted)).register_type(&*participant_);
  found = participant_->create_topic(std::string(wanted.name), std::string(wanted.type), dds::TOPIC_QOS_DEFAULT);
  if (found == nullptr) throw BusError("Fast DDS cannot make topic " + std::string(wanted.name));
  return *found;
}

std::unique_ptr<Writer> FastBus::writer(Topic topic, const std::string& partition) {
  return make_writer(*participant_, topic_of(topic), traits(topic), partition);
}

std::unique_ptr<Reader> FastBus::reader(Topic topic, const std::string& partition, ReaderEvents events) {
  return make_reader(*participant_, topic_of(topic), traits(topic), partition, std::move(events));
}

std::string FastBus::version() const { return FOOTHOLD_FASTDDS_VERSION; }

}  // namespace foothold::transport::fastdds

FOOTHOLD_BUS_ENTRY(const foothold::transport::BusOptions& options) { return new foothold::transport::fastdds::FastBus(options); }
