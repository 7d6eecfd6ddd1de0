// A writer that keeps all holds what is not acknowledged (bounded by the watermarks of the configuration, in octets) and, for late
// readers, the newest `history` samples: the durability service's depth rolls over, so the writer never fills up for good.
#include "qos.hpp"

namespace foothold::transport::cyclone {
namespace {

constexpr dds_duration_t kLivelinessLease = DDS_SECS(1);

Qos common_qos(const TopicTraits& topic) {
  Qos qos(dds_create_qos());
  // Nothing blocks in a write; whoever writes tries again.
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, 0);
  dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
  dds_qset_history(qos.get(), topic.keep_last_one ? DDS_HISTORY_KEEP_LAST : DDS_HISTORY_KEEP_ALL, 1);
  const dds_data_representation_id_t representation = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &representation);
  if (topic.liveliness) dds_qset_liveliness(qos.get(), DDS_LIVELINESS_MANUAL_BY_TOPIC, kLivelinessLease);
  return qos;
}

}  // namespace

Qos writer_qos(const TopicTraits& topic) {
  Qos qos = common_qos(topic);
  const std::int32_t depth = topic.keep_last_one ? 1 : topic.history;
  dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, depth, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED, depth);
  if (topic.lifespan > 0) dds_qset_lifespan(qos.get(), DDS_SECS(topic.lifespan));
  dds_qset_writer_data_lifecycle(qos.get(), false);
  return qos;
}

Qos reader_qos(const TopicTraits& topic) {
  Qos qos = common_qos(topic);
  // No bounds: the listener takes samples at once. At a bound (the history that a new reader in the writer's process is given, or
  // many keys) Cyclone would stop receiving.
  dds_qset_resource_limits(qos.get(), DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  return qos;
}

Qos partition_qos(const std::string& partition) {
  Qos qos(dds_create_qos());
  const char* name = partition.c_str();
  if (!partition.empty()) dds_qset_partition(qos.get(), 1, &name);
  return qos;
}

}  // namespace foothold::transport::cyclone
