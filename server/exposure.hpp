// Who can reach this server over DDS, and what keeps others out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "config/config.hpp"

namespace foothold::server {

// What is wrong with the credentials that `dds.security` names, in one sentence; empty: nothing, or none are named.
std::string fault_of_security(const DdsConfig& dds);

// Tells the log who can speak with this server: the credentials and how long they are valid, or what is open without them. Gives
// the time (Unix, s) when they end. Throws SecurityError.
std::optional<std::int64_t> tell_exposure(const DdsConfig& dds);

}  // namespace foothold::server
