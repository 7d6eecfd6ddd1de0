// Bounded histories: unlimited ones fall to a tenth of the throughput. Short heartbeats and prompt answers: the defaults (3 s, 5 to
// 70 ms) are how long a late reader, a lost datagram or a full window would wait.
#include "qos.hpp"

namespace foothold::transport::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::Duration_t;

const Duration_t kHeartbeat(0, 10'000'000);
const Duration_t kPrompt(0, 1'000'000);
// Between questions of a reader to a writer that has not found it yet; they go on until it has.
const Duration_t kKnock(0, 20'000'000);
const Duration_t kLivelinessLease(1, 0);
const Duration_t kLivelinessAnnouncement(0, 300'000'000);

// What readers and writers share.
template <class Qos>
void set_common(const TopicTraits& topic, Qos& qos) {
  qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  qos.history().kind = topic.keep_last_one ? dds::KEEP_LAST_HISTORY_QOS : dds::KEEP_ALL_HISTORY_QOS;
  qos.history().depth = 1;
  auto& limits = qos.resource_limits();
  limits.max_samples = topic.history;
  limits.max_instances = topic.keyed ? topic.history : 1;
  limits.max_samples_per_instance = topic.keep_last_one ? 1 : topic.history;
  limits.allocated_samples = 0;
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  qos.data_sharing().off();
  if (topic.liveliness) {
    qos.liveliness().kind = dds::MANUAL_BY_TOPIC_LIVELINESS_QOS;
    qos.liveliness().lease_duration = kLivelinessLease;
    qos.liveliness().announcement_period = kLivelinessAnnouncement;
  }
}

}  // namespace

dds::DataWriterQos writer_qos(const TopicTraits& topic) {
  dds::DataWriterQos qos;
  set_common(topic, qos);
  if (topic.lifespan > 0) qos.lifespan().duration = Duration_t(topic.lifespan, 0);
  // Nothing blocks in a write; whoever writes tries again.
  qos.reliability().max_blocking_time = Duration_t(0, 0);
  qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  qos.representation().m_value = {dds::XCDR_DATA_REPRESENTATION};
  auto& times = qos.reliable_writer_qos().times;
  times.heartbeatPeriod = kHeartbeat;
  times.initialHeartbeatDelay = kPrompt;
  times.nackResponseDelay = kPrompt;
  return qos;
}

dds::DataReaderQos reader_qos(const TopicTraits& topic) {
  dds::DataReaderQos qos;
  set_common(topic, qos);
  if (topic.keyed) {  // beyond a bound on keys Fast DDS acknowledges samples and drops them; 0: none
    qos.resource_limits().max_samples = 0;
    qos.resource_limits().max_instances = 0;
  }
  auto& times = qos.reliable_reader_qos().times;
  times.initialAcknackDelay = kKnock;
  times.heartbeatResponseDelay = kPrompt;
  qos.type_consistency().representation.m_value = {dds::XCDR_DATA_REPRESENTATION};
  return qos;
}

dds::PublisherQos publisher_qos(const std::string& partition) {
  dds::PublisherQos qos;
  if (!partition.empty()) qos.partition().push_back(partition.c_str());
  return qos;
}

dds::SubscriberQos subscriber_qos(const std::string& partition) {
  dds::SubscriberQos qos;
  if (!partition.empty()) qos.partition().push_back(partition.c_str());
  return qos;
}

}  // namespace foothold::transport::fastdds
