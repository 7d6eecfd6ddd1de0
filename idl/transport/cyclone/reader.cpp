// Takes octets in Cyclone's listener, on the thread that received them. Cyclone calls the listeners of one entity one at a time and
// dds_delete waits for the one that runs.
#include "bus.hpp"
#include "qos.hpp"

namespace foothold::transport::cyclone {
namespace {

constexpr std::uint32_t kTakenAtOnce = 64;

void on_data(dds_entity_t reader, void* argument) {
  const auto& events = *static_cast<const ReaderEvents*>(argument);
  std::array<ddsi_serdata*, kTakenAtOnce> samples{};
  std::array<dds_sample_info_t, kTakenAtOnce> infos;
  dds_return_t taken = 0;
  do {
    taken = dds_takecdr(reader, samples.data(), kTakenAtOnce, infos.data(), DDS_ANY_STATE);
    for (dds_return_t i = 0; i < taken; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (infos[at].valid_data) events.on_message(octets(samples[at]));
      ddsi_serdata_unref(samples[at]);
    }
  } while (taken == static_cast<dds_return_t>(kTakenAtOnce));
}

void on_matched(dds_entity_t, dds_subscription_matched_status_t status, void* argument) {
  static_cast<const ReaderEvents*>(argument)->on_matched(status.current_count);
}

void on_liveliness(dds_entity_t, dds_liveliness_changed_status_t status, void* argument) {
  static_cast<const ReaderEvents*>(argument)->on_liveliness(status.alive_count);
}

struct DeleteListener {
  void operator()(dds_listener_t* listener) const { dds_delete_listener(listener); }
};

class CycloneReader final : public Reader {
 public:
  CycloneReader(dds_entity_t participant, const BytesTopic& bytes_topic, const TopicTraits& topic, const std::string& partition,
                ReaderEvents events)
      : events_(std::move(events)),
        subscriber_(dds_create_subscriber(participant, partition_qos(partition).get(), nullptr), "a subscriber") {
    const std::unique_ptr<dds_listener_t, DeleteListener> listener(dds_create_listener(&events_));
    dds_lset_data_available(listener.get(), on_data);
    if (events_.on_matched) dds_lset_subscription_matched(listener.get(), on_matched);
    if (events_.on_liveliness) dds_lset_liveliness_changed(listener.get(), on_liveliness);
    reader_ = Entity(dds_create_reader(subscriber_.get(), bytes_topic.entity.get(), reader_qos(topic).get(), listener.get()),
                     "a reader of " + std::string(topic.name));
  }

  std::size_t matched() const override {
    dds_subscription_matched_status_t status{};
    return dds_get_subscription_matched_status(reader_.get(), &status) == DDS_RETCODE_OK ? status.current_count : 0;
  }

 private:
  ReaderEvents events_;
  Entity subscriber_;
  Entity reader_;
};

}  // namespace

std::unique_ptr<Reader> make_reader(dds_entity_t participant, const BytesTopic& bytes_topic, const TopicTraits& topic,
                                    const std::string& partition, ReaderEvents events) {
  return std::make_unique<CycloneReader>(participant, bytes_topic, topic, partition, std::move(events));
}

}  // namespace foothold::transport::cyclone
