// Takes octets in Cyclone's listener, on the thread that received them. Cyclone calls the listeners of one entity one at a time and
// dds_delete waits for the one that runs.
#include <algorithm>
#include <unordered_map>

#include "bus.hpp"
#include "qos.hpp"

namespace foothold::transport::cyclone {
namespace {

constexpr std::uint32_t kTakenAtOnce = 64;

// Asked of Cyclone once for each writer. For one reader, whose listener is called by one thread at a time.
class Senders {
 public:
  Sender of(dds_entity_t reader, dds_instance_handle_t writer) {
    if (const auto found = known_.find(writer); found != known_.end()) return found->second;
    Sender sender{};
    dds_builtintopic_endpoint_t* endpoint = dds_get_matched_publication_data(reader, writer);
    if (endpoint == nullptr) return sender;
    std::copy_n(endpoint->participant_key.v, sender.size(), sender.begin());
    dds_builtintopic_free_endpoint(endpoint);
    if (known_.size() >= kMost) known_.clear();
    known_.emplace(writer, sender);
    return sender;
  }

 private:
  static constexpr std::size_t kMost = 4096;
  std::unordered_map<dds_instance_handle_t, Sender> known_;
};

struct Listened {
  ReaderEvents events;
  Senders senders;
};

void tell(dds_entity_t reader, Listened& listened, const ddsi_serdata* sample, const dds_sample_info_t& info) {
  if (listened.events.on_message_from)
    listened.events.on_message_from(octets(sample), listened.senders.of(reader, info.publication_handle));
  else
    listened.events.on_message(octets(sample));
}

void on_data(dds_entity_t reader, void* argument) {
  auto& listened = *static_cast<Listened*>(argument);
  std::array<ddsi_serdata*, kTakenAtOnce> samples{};
  std::array<dds_sample_info_t, kTakenAtOnce> infos;
  dds_return_t taken = 0;
  do {
    taken = dds_takecdr(reader, samples.data(), kTakenAtOnce, infos.data(), DDS_ANY_STATE);
    for (dds_return_t i = 0; i < taken; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (infos[at].valid_data) tell(reader, listened, samples[at], infos[at]);
      ddsi_serdata_unref(samples[at]);
    }
  } while (taken == static_cast<dds_return_t>(kTakenAtOnce));
}

void on_matched(dds_entity_t, dds_subscription_matched_status_t status, void* argument) {
  static_cast<Listened*>(argument)->events.on_matched(status.current_count);
}

void on_liveliness(dds_entity_t, dds_liveliness_changed_status_t status, void* argument) {
  static_cast<Listened*>(argument)->events.on_liveliness(status.alive_count);
}

struct DeleteListener {
  void operator()(dds_listener_t* listener) const { dds_delete_listener(listener); }
};

class CycloneReader final : public Reader {
 public:
  CycloneReader(dds_entity_t participant, const BytesTopic& bytes_topic, const TopicTraits& topic, const std::string& partition,
                ReaderEvents events)
      : listened_{std::move(events), {}},
        subscriber_(dds_create_subscriber(participant, partition_qos(partition).get(), nullptr), "a subscriber") {
    const std::unique_ptr<dds_listener_t, DeleteListener> listener(dds_create_listener(&listened_));
    dds_lset_data_available(listener.get(), on_data);
    if (listened_.events.on_matched) dds_lset_subscription_matched(listener.get(), on_matched);
    if (listened_.events.on_liveliness) dds_lset_liveliness_changed(listener.get(), on_liveliness);
    reader_ = Entity(dds_create_reader(subscriber_.get(), bytes_topic.entity.get(), reader_qos(topic).get(), listener.get()),
                     "a reader of " + std::string(topic.name));
  }

  std::size_t matched() const override {
    dds_subscription_matched_status_t status{};
    return dds_get_subscription_matched_status(reader_.get(), &status) == DDS_RETCODE_OK ? status.current_count : 0;
  }

 private:
  Listened listened_;
  Entity subscriber_;
  Entity reader_;
};

}  // namespace

std::unique_ptr<Reader> make_reader(dds_entity_t participant, const BytesTopic& bytes_topic, const TopicTraits& topic,
                                    const std::string& partition, ReaderEvents events) {
  return std::make_unique<CycloneReader>(participant, bytes_topic, topic, partition, std::move(events));
}

}  // namespace foothold::transport::cyclone
