// From the table of topics to Fast DDS's quality of service.
#pragma once

#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/publisher/qos/PublisherQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/subscriber/qos/SubscriberQos.hpp>

#include <string>

#include "foothold/transport/topics.hpp"

namespace foothold::transport::fastdds {

eprosima::fastdds::dds::DataWriterQos writer_qos(const TopicTraits& topic);
eprosima::fastdds::dds::DataReaderQos reader_qos(const TopicTraits& topic);
// Partition empty: the default one.
eprosima::fastdds::dds::PublisherQos publisher_qos(const std::string& partition);
eprosima::fastdds::dds::SubscriberQos subscriber_qos(const std::string& partition);

}  // namespace foothold::transport::fastdds
