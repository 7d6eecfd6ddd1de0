// A topic type of Cyclone DDS whose samples are CDR octets as they are: no C structs, no code that copies field by field. Cyclone
// asks for the key of keyed topics and for the octets, nothing else.
#pragma once

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>

#include <span>

#include "../encapsulation.hpp"

namespace foothold::transport::cyclone {

// For dds_create_topic_sertype, which takes it over if it succeeds; else ddsi_sertype_unref() it.
ddsi_sertype* new_bytes_type(const TopicTraits& topic);

// A sample to write; release it by ddsi_serdata_unref or hand it to dds_writecdr, which takes it over. `type` is the one that
// dds_create_topic_sertype returned. Precondition: no fault_of(topic, message).
ddsi_serdata* new_sample(const ddsi_sertype* type, std::span<const std::byte> message);

// The octets of a sample that was taken from a reader of such a type. They live as long as the sample.
std::span<const std::byte> octets(const ddsi_serdata* sample);

}  // namespace foothold::transport::cyclone
