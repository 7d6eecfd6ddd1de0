// From the table of topics to Cyclone's quality of service.
#pragma once

#include <dds/dds.h>

#include <memory>
#include <string>

#include "foothold/transport/topics.hpp"

namespace foothold::transport::cyclone {

struct DeleteQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, DeleteQos>;

Qos writer_qos(const TopicTraits& topic);
Qos reader_qos(const TopicTraits& topic);
// For a publisher or subscriber; empty: the default partition.
Qos partition_qos(const std::string& partition);

}  // namespace foothold::transport::cyclone
