// A client of somebody else's: Cyclone DDS with idlc's C structs, none of our code. plain_cyclone DOMAIN TOPIC: takes what comes in
// the partition "plain" and writes it to the partition "back". Ends when stdin does. Configured by
// CYCLONEDDS_URI.
#include <dds/dds.h>
#include <foothold.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

namespace {

struct NamedType {
  const char* topic;
  const dds_topic_descriptor_t* type;
};

constexpr NamedType kTypes[] = {
    {"foothold/request", &foothold_msg_PlanRequest_desc},
    {"foothold/cancel", &foothold_msg_CancelRequest_desc},
    {"foothold/query", &foothold_msg_StateQuery_desc},
    {"foothold/event", &foothold_msg_PlanEvent_desc},
    {"foothold/step", &foothold_msg_Step_desc},
    {"foothold/scene", &foothold_msg_SceneChunk_desc},
    {"foothold/scene_status", &foothold_msg_SceneStatus_desc},
    {"foothold/robot", &foothold_msg_RobotInfo_desc},
    {"foothold/server", &foothold_msg_ServerInfo_desc},
};

dds_entity_t must(dds_entity_t entity, const char* what) {
  if (entity >= 0) return entity;
  std::fprintf(stderr, "plain_cyclone: %s: %s\n", what, dds_strretcode(entity));
  std::exit(1);
}

dds_qos_t* in_partition(const char* name) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_partition(qos, 1, &name);
  return qos;
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  const dds_topic_descriptor_t* type = nullptr;
  for (const NamedType& named : kTypes) {
    if (std::strcmp(named.topic, words[2]) == 0) type = named.type;
  }
  if (type == nullptr) return 2;
  const auto domain = static_cast<dds_domainid_t>(std::atoi(words[1]));
  const dds_entity_t participant = must(dds_create_participant(domain, nullptr, nullptr), "participant");
  const dds_entity_t topic = must(dds_create_topic(participant, type, words[2], nullptr, nullptr), "topic");
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(5));
  dds_qset_durability(qos, DDS_DURABILITY_TRANSIENT_LOCAL);
  dds_qset_history(qos, DDS_HISTORY_KEEP_ALL, 0);
  dds_qset_durability_service(qos, 0, DDS_HISTORY_KEEP_LAST, 100, -1, -1, -1);
  const dds_data_representation_id_t representation = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos, 1, &representation);
  const dds_entity_t subscriber = must(dds_create_subscriber(participant, in_partition("plain"), nullptr), "subscriber");
  const dds_entity_t publisher = must(dds_create_publisher(participant, in_partition("back"), nullptr), "publisher");
  const dds_entity_t reader = must(dds_create_reader(subscriber, topic, qos, nullptr), "reader");
  dds_qset_liveliness(qos, DDS_LIVELINESS_MANUAL_BY_TOPIC, DDS_SECS(1));  // the readers of foothold/server ask for it
  const dds_entity_t writer = must(dds_create_writer(publisher, topic, qos, nullptr), "writer");
  std::jthread relay([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      void* samples[16] = {};
      dds_sample_info_t infos[16];
      const dds_return_t taken = dds_take(reader, samples, infos, 16, 16);
      for (dds_return_t i = 0; i < taken; ++i) {
        if (infos[i].valid_data) must(dds_write(writer, samples[i]), "write");
      }
      if (taken > 0) dds_return_loan(reader, samples, taken);
      if (taken <= 0) dds_sleepfor(DDS_MSECS(1));
    }
  });
  while (std::getchar() != EOF) {
  }
  relay.request_stop();
  relay.join();
  dds_delete(participant);
}
