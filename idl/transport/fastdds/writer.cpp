// Writes octets. Fast DDS refuses a sample at once (its blocking time is 0) while its history is full and the oldest sample is not
// acknowledged.
#include <chrono>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <mutex>

#include "bus.hpp"
#include "bytes_type.hpp"
#include "qos.hpp"

namespace foothold::transport::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

// How much may be under way before all of it is acknowledged. Fast DDS itself would send a whole history; what a reader's socket
// cannot hold is then lost and repaired, and its reader walks through all that came out of order for each sample repaired.
constexpr std::size_t kWindowSamples = 256;
constexpr std::size_t kWindowOctets = 256U << 10U;

// How long a full window waits for who acknowledges nothing. A reader that died without a word is one until its lease ends, and the
// others wait with it; what it leaves unacknowledged is bounded by the history.
constexpr auto kPatience = std::chrono::milliseconds(100);

class FastWriter final : public Writer {
 public:
  FastWriter(dds::DomainParticipant& participant, dds::Topic& dds_topic, const TopicTraits& topic, const std::string& partition)
      : topic_(topic), participant_(participant), publisher_(participant.create_publisher(publisher_qos(partition))) {
    if (publisher_ == nullptr) throw BusError("Fast DDS cannot make a publisher in partition '" + partition + "'");
    writer_ = publisher_->create_datawriter(&dds_topic, writer_qos(topic));
    if (writer_ == nullptr) {
      participant_.delete_publisher(publisher_);
      throw BusError("Fast DDS cannot make a writer of " + std::string(topic.name));
    }
  }

  // Fast DDS 2.9 gives samples back one by one while it deletes a writer, and its heartbeat, on another thread, can walk through
  // the list meanwhile, for ever. An empty history has nothing to walk through.
  ~FastWriter() override {
    std::size_t removed = 0;
    writer_->clear_history(&removed);
    publisher_->delete_datawriter(writer_);
    participant_.delete_publisher(publisher_);
  }

  Result write(std::span<const std::byte> message) override {
    if (const char* fault = fault_of(topic_, message)) return failed(describe(topic_, message, fault));
    const bool replaces = topic_.keep_last_one;  // what is not acknowledged: nothing piles up, and nobody holds up the others
    if (!replaces && window_is_full()) {
      const bool goes_on = all_acknowledged() || Clock::now() - filled_ >= kPatience;
      if (!goes_on) return Result::kFull;
      window_samples_ = window_octets_ = 0;
    }
    BytesSample sample{message, {}};
    const ReturnCode_t code = writer_->write(&sample, dds::HANDLE_NIL);
    if (code == ReturnCode_t::RETCODE_OK) {
      ++window_samples_;
      window_octets_ += message.size();
      if (!replaces && window_is_full()) filled_ = Clock::now();
      return Result::kSent;
    }
    // The newest sample of each key replaces the one before, so that only the number of keys can be too large.
    if (topic_.keyed) return failed("refused; more than " + std::to_string(topic_.history) + " keys?");
    if (code == ReturnCode_t::RETCODE_TIMEOUT || code == ReturnCode_t::RETCODE_OUT_OF_RESOURCES) return Result::kFull;
    return failed("DataWriter::write gave return code " + std::to_string(code()));
  }

  std::string last_error() const override {
    const std::lock_guard lock(mutex_);
    return last_error_;
  }

  std::size_t matched() const override {
    dds::PublicationMatchedStatus status;
    if (writer_->get_publication_matched_status(status) != ReturnCode_t::RETCODE_OK) return 0;
    return static_cast<std::size_t>(status.current_count);
  }

  void assert_liveliness() override { writer_->assert_liveliness(); }

  bool wait_acknowledged(double seconds) override {
    return writer_->wait_for_acknowledgments(eprosima::fastrtps::Duration_t(static_cast<long double>(seconds))) ==
           ReturnCode_t::RETCODE_OK;
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool window_is_full() const { return window_samples_ >= kWindowSamples || window_octets_ >= kWindowOctets; }

  bool all_acknowledged() {
    return writer_->wait_for_acknowledgments(eprosima::fastrtps::Duration_t(0, 0)) == ReturnCode_t::RETCODE_OK;
  }

  Result failed(std::string why) {
    const std::lock_guard lock(mutex_);
    last_error_ = std::move(why);
    return Result::kFailed;
  }

  const TopicTraits& topic_;
  dds::DomainParticipant& participant_;
  dds::Publisher* publisher_;
  dds::DataWriter* writer_ = nullptr;
  std::size_t window_samples_ = 0;  // since it was empty
  std::size_t window_octets_ = 0;
  Clock::time_point filled_;
  mutable std::mutex mutex_;
  std::string last_error_;
};

}  // namespace

std::unique_ptr<Writer> make_writer(dds::DomainParticipant& participant, dds::Topic& dds_topic, const TopicTraits& topic,
                                    const std::string& partition) {
  return std::make_unique<FastWriter>(participant, dds_topic, topic, partition);
}

}  // namespace foothold::transport::fastdds
