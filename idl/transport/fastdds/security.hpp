// DDS Security with Fast DDS' own plugins.
#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

#include <string>

namespace foothold::transport::fastdds {

// Adds what a participant with these credentials (a folder) needs.
void secure(eprosima::fastdds::dds::DomainParticipantQos& qos, const std::string& security);

}  // namespace foothold::transport::fastdds
