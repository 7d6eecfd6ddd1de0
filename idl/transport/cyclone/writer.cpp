// Writes octets. Cyclone refuses a sample at once (its blocking time is 0) while more than the high watermark is not acknowledged.
#include <mutex>

#include "bus.hpp"
#include "qos.hpp"

namespace foothold::transport::cyclone {
namespace {

class CycloneWriter final : public Writer {
 public:
  CycloneWriter(dds_entity_t participant, const BytesTopic& bytes_topic, const TopicTraits& topic, const std::string& partition)
      : topic_(topic),
        type_(bytes_topic.type),
        publisher_(dds_create_publisher(participant, partition_qos(partition).get(), nullptr), "a publisher"),
        writer_(dds_create_writer(publisher_.get(), bytes_topic.entity.get(), writer_qos(topic).get(), nullptr),
                "a writer of " + std::string(topic.name)) {}

  Result write(std::span<const std::byte> message) override {
    if (const char* fault = fault_of(topic_, message)) return failed(describe(topic_, message, fault));
    const dds_return_t code = dds_writecdr(writer_.get(), new_sample(type_, message));
    if (code == DDS_RETCODE_OK) return Result::kSent;
    if (code == DDS_RETCODE_TIMEOUT) return Result::kFull;
    return failed(std::string("dds_writecdr: ") + dds_strretcode(code));
  }

  std::string last_error() const override {
    const std::lock_guard lock(mutex_);
    return last_error_;
  }

  std::size_t matched() const override {
    dds_publication_matched_status_t status{};
    return dds_get_publication_matched_status(writer_.get(), &status) == DDS_RETCODE_OK ? status.current_count : 0;
  }

  void assert_liveliness() override { dds_assert_liveliness(writer_.get()); }

  bool wait_acknowledged(double seconds) override {
    return dds_wait_for_acks(writer_.get(), static_cast<dds_duration_t>(seconds * 1e9)) == DDS_RETCODE_OK;
  }

 private:
  Result failed(std::string why) {
    const std::lock_guard lock(mutex_);
    last_error_ = std::move(why);
    return Result::kFailed;
  }

  const TopicTraits& topic_;
  const ddsi_sertype* type_;
  Entity publisher_;
  Entity writer_;
  mutable std::mutex mutex_;
  std::string last_error_;
};

}  // namespace

std::unique_ptr<Writer> make_writer(dds_entity_t participant, const BytesTopic& bytes_topic, const TopicTraits& topic,
                                    const std::string& partition) {
  return std::make_unique<CycloneWriter>(participant, bytes_topic, topic, partition);
}

}  // namespace foothold::transport::cyclone
