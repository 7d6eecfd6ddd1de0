// A writer without manners: raw_fastdds DOMAIN TOPIC TYPE. Each frame of stdin goes out as a sample of that topic, whatever it
// holds, the encapsulation included. Tells how many readers are matched. Configured by FASTRTPS_DEFAULT_PROFILES_FILE.
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <thread>

#include "frames.hpp"

namespace {

using namespace eprosima::fastdds::dds;
using eprosima::fastrtps::rtps::InstanceHandle_t;
using eprosima::fastrtps::rtps::SerializedPayload_t;
using Octets = std::vector<std::byte>;

class AnyOctets final : public TopicDataType {
 public:
  AnyOctets(const char* name, bool keyed) {
    setName(name);
    m_typeSize = 64;
    m_isGetKeyDefined = keyed;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }
  bool serialize(void* data, SerializedPayload_t* payload) override {
    const auto& octets = *static_cast<const Octets*>(data);
    if (!octets.empty()) std::memcpy(payload->data, octets.data(), octets.size());
    payload->length = static_cast<std::uint32_t>(octets.size());
    return true;
  }
  bool deserialize(SerializedPayload_t*, void*) override { return false; }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [size = static_cast<std::uint32_t>(static_cast<const Octets*>(data)->size())] { return size; };
  }
  void* createData() override { return new Octets; }
  void deleteData(void* data) override { delete static_cast<Octets*>(data); }
  // All samples have one key, whatever they say.
  bool getKey(void*, InstanceHandle_t* handle, bool) override {
    handle->value[0] = 1;
    return m_isGetKeyDefined;
  }
};

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  auto& factory = *DomainParticipantFactory::get_instance();
  auto* participant = factory.create_participant(static_cast<DomainId_t>(std::atoi(words[1])), PARTICIPANT_QOS_DEFAULT);
  const bool keyed = std::strcmp(words[2], "foothold/robot") == 0 || std::strcmp(words[2], "foothold/server") == 0;
  const TypeSupport type(new AnyOctets(words[3], keyed));
  type.register_type(participant);
  auto* topic = participant->create_topic(words[2], words[3], TOPIC_QOS_DEFAULT);
  auto* publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
  DataWriterQos qos;
  qos.durability().kind = TRANSIENT_LOCAL_DURABILITY_QOS;
  qos.history().kind = KEEP_ALL_HISTORY_QOS;
  qos.resource_limits().max_samples = 5000;
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples_per_instance = 5000;
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  qos.liveliness().kind = MANUAL_BY_TOPIC_LIVELINESS_QOS;
  qos.liveliness().lease_duration = {1, 0};
  qos.liveliness().announcement_period = {0, 300'000'000};
  qos.reliable_writer_qos().times.heartbeatPeriod = {0, 20'000'000};
  auto* writer = publisher->create_datawriter(topic, qos);
  PublicationMatchedStatus status;
  while (status.current_count == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    writer->get_publication_matched_status(status);
  }
  foothold::test::put_number(STDOUT_FILENO, foothold::test::Kind::kMatched, 1);
  while (auto frame = foothold::test::get_frame(STDIN_FILENO)) {
    while (!writer->write(&frame->octets)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  writer->wait_for_acknowledgments({10, 0});
  participant->delete_contained_entities();
  factory.delete_participant(participant);
}
