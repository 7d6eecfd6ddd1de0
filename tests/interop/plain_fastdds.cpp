// A client of somebody else's: Fast DDS with fastddsgen's types, none of our code. plain_fastdds DOMAIN TOPIC: takes what comes in
// the partition "plain" and writes it to the partition "back". Ends when stdin does. Configured by
// FASTRTPS_DEFAULT_PROFILES_FILE.
#include <footholdPubSubTypes.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <thread>

namespace {

using namespace eprosima::fastdds::dds;
namespace msg = foothold::msg;
using eprosima::fastrtps::types::ReturnCode_t;

TopicDataType* type_of(const char* topic) {
  const auto is = [topic](const char* name) { return std::strcmp(topic, name) == 0; };
  if (is("foothold/request")) return new msg::PlanRequestPubSubType;
  if (is("foothold/cancel")) return new msg::CancelRequestPubSubType;
  if (is("foothold/query")) return new msg::StateQueryPubSubType;
  if (is("foothold/event")) return new msg::PlanEventPubSubType;
  if (is("foothold/step")) return new msg::StepPubSubType;
  if (is("foothold/scene")) return new msg::SceneChunkPubSubType;
  if (is("foothold/scene_status")) return new msg::SceneStatusPubSubType;
  if (is("foothold/robot")) return new msg::RobotInfoPubSubType;
  if (is("foothold/server")) return new msg::ServerInfoPubSubType;
  std::exit(2);
}

template <class Qos>
Qos endpoint_qos() {
  Qos qos;
  qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = TRANSIENT_LOCAL_DURABILITY_QOS;
  qos.history().kind = KEEP_ALL_HISTORY_QOS;
  qos.resource_limits().max_instances = 100;
  qos.resource_limits().max_samples_per_instance = 100;
  qos.resource_limits().max_samples = 10'000;
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  return qos;
}

template <class Entity>
Entity* must(Entity* entity, const char* what) {
  if (entity != nullptr) return entity;
  std::fprintf(stderr, "plain_fastdds: no %s\n", what);
  std::exit(1);
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  auto& factory = *DomainParticipantFactory::get_instance();
  auto* participant =
      must(factory.create_participant(static_cast<DomainId_t>(std::atoi(words[1])), PARTICIPANT_QOS_DEFAULT), "participant");
  const TypeSupport type(type_of(words[2]));
  type.register_type(participant);
  auto* topic = must(participant->create_topic(words[2], type.get_type_name(), TOPIC_QOS_DEFAULT), "topic");
  PublisherQos to_back;
  to_back.partition().push_back("back");
  SubscriberQos from_plain;
  from_plain.partition().push_back("plain");
  auto* writer_parent = must(participant->create_publisher(to_back), "publisher");
  auto* reader_parent = must(participant->create_subscriber(from_plain), "subscriber");
  auto writer_qos = endpoint_qos<DataWriterQos>();
  writer_qos.liveliness().kind = MANUAL_BY_TOPIC_LIVELINESS_QOS;  // the readers of foothold/server ask for it
  writer_qos.liveliness().lease_duration = {1, 0};
  writer_qos.liveliness().announcement_period = {0, 300'000'000};
  auto* writer = must(writer_parent->create_datawriter(topic, writer_qos), "writer");
  auto* reader = must(reader_parent->create_datareader(topic, endpoint_qos<DataReaderQos>()), "reader");
  std::jthread relay([&](const std::stop_token& stop) {
    void* sample = type->createData();
    SampleInfo info;
    while (!stop.stop_requested()) {
      if (reader->take_next_sample(sample, &info) == ReturnCode_t::RETCODE_OK) {
        while (info.valid_data && !writer->write(sample) && !stop.stop_requested())
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
      } else {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    }
    type->deleteData(sample);
  });
  while (std::getchar() != EOF) {
  }
  relay.request_stop();
  relay.join();
  participant->delete_contained_entities();
  factory.delete_participant(participant);
}
