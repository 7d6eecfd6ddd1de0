// DDS Security with Cyclone DDS' own plugins.
#pragma once

#include "qos.hpp"

namespace foothold::transport::cyclone {

// Of a participant with these credentials (a folder), or of one without security if it is empty.
Qos participant_qos(const std::string& security);

}  // namespace foothold::transport::cyclone
