// Takes octets in Fast DDS's listener, on the thread that received them.
#include <algorithm>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <mutex>

#include "bus.hpp"
#include "bytes_type.hpp"
#include "qos.hpp"

namespace foothold::transport::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

// Fast DDS tells of data and of liveliness on different threads: the lock keeps the callbacks apart.
class Listener final : public dds::DataReaderListener {
 public:
  explicit Listener(ReaderEvents events) : events_(std::move(events)) {}

  void on_data_available(dds::DataReader* reader) override {
    const std::lock_guard lock(mutex_);
    dds::SampleInfo info;
    while (reader->take_next_sample(&sample_, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      if (!events_.on_message_from) {
        events_.on_message(sample_.in);
        continue;
      }
      Sender sender;
      std::copy_n(info.sample_identity.writer_guid().guidPrefix.value, sender.size(), sender.begin());
      events_.on_message_from(sample_.in, sender);
    }
  }

  void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
    const std::lock_guard lock(mutex_);
    if (events_.on_matched) events_.on_matched(static_cast<std::size_t>(status.current_count));
  }

  void on_liveliness_changed(dds::DataReader*, const dds::LivelinessChangedStatus& status) override {
    const std::lock_guard lock(mutex_);
    if (events_.on_liveliness) events_.on_liveliness(static_cast<std::size_t>(status.alive_count));
  }

 private:
  const ReaderEvents events_;
  std::mutex mutex_;
  BytesSample sample_;  // its memory is used again and again
};

class FastReader final : public Reader {
 public:
  FastReader(dds::DomainParticipant& participant, dds::Topic& dds_topic, const TopicTraits& topic, const std::string& partition,
             ReaderEvents events)
      : participant_(participant),
        listener_(std::move(events)),
        subscriber_(participant.create_subscriber(subscriber_qos(partition))) {
    if (subscriber_ == nullptr) throw BusError("Fast DDS cannot make a subscriber in partition '" + partition + "'");
    reader_ = subscriber_->create_datareader(&dds_topic, reader_qos(topic), &listener_);
    if (reader_ == nullptr) {
      participant_.delete_subscriber(subscriber_);
      throw BusError("Fast DDS cannot make a reader of " + std::string(topic.name));
    }
  }

  ~FastReader() override {
    reader_->set_listener(nullptr);
    subscriber_->delete_datareader(reader_);
    participant_.delete_subscriber(subscriber_);
  }

  std::size_t matched() const override {
    dds::SubscriptionMatchedStatus status;
    if (reader_->get_subscription_matched_status(status) != ReturnCode_t::RETCODE_OK) return 0;
    return static_cast<std::size_t>(status.current_count);
  }

 private:
  dds::DomainParticipant& participant_;
  Listener listener_;
  dds::Subscriber* subscriber_;
  dds::DataReader* reader_ = nullptr;
};

}  // namespace

std::unique_ptr<Reader> make_reader(dds::DomainParticipant& participant, dds::Topic& dds_topic, const TopicTraits& topic,
                                    const std::string& partition, ReaderEvents events) {
  return std::make_unique<FastReader>(participant, dds_topic, topic, partition, std::move(events));
}

}  // namespace foothold::transport::fastdds
