// The bus on Fast DDS 2.9: one participant, a topic per row of the table, a publisher or subscriber per writer or reader (a
// partition belongs to them).
#pragma once

#include <fastdds/dds/topic/Topic.hpp>

#include <array>
#include <mutex>

#include "participant.hpp"

namespace foothold::transport::fastdds {

class FastBus final : public Bus {
 public:
  explicit FastBus(const BusOptions& options);
  std::unique_ptr<Writer> writer(Topic topic, const std::string& partition) override;
  std::unique_ptr<Reader> reader(Topic topic, const std::string& partition, ReaderEvents events) override;
  std::string_view vendor() const override { return "fastdds"; }
  std::string version() const override;

 private:
  eprosima::fastdds::dds::Topic& topic_of(Topic topic);

  Participant participant_;
  std::mutex mutex_;  // of topics_
  std::array<eprosima::fastdds::dds::Topic*, kTopicCount> topics_{};
};

std::unique_ptr<Writer> make_writer(eprosima::fastdds::dds::DomainParticipant& participant,
                                    eprosima::fastdds::dds::Topic& dds_topic, const TopicTraits& topic,
                                    const std::string& partition);
std::unique_ptr<Reader> make_reader(eprosima::fastdds::dds::DomainParticipant& participant,
                                    eprosima::fastdds::dds::Topic& dds_topic, const TopicTraits& topic,
                                    const std::string& partition, ReaderEvents events);

}  // namespace foothold::transport::fastdds
