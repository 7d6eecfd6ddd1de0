// How much a request may hold (idl/PROTOCOL.md, P4). Octets for text, elements for sequences.
#pragma once

#include <cstddef>

namespace foothold::server::limits {

inline constexpr std::size_t kRequest = 64 * 1024;  // the whole message, as it travels
inline constexpr std::size_t kRobot = 64;
inline constexpr std::size_t kUnit = 128;
inline constexpr std::size_t kScene = 64;
inline constexpr std::size_t kParameters = 64;
inline constexpr std::size_t kParameterName = 64;
inline constexpr std::size_t kParameterValue = 1024;
inline constexpr std::size_t kContacts = 64;
inline constexpr std::size_t kLimb = 64;
inline constexpr std::size_t kFace = 64;
inline constexpr std::size_t kJoints = 256;
inline constexpr std::size_t kBase = 1;
inline constexpr std::size_t kReason = 1024;  // of a cancel
inline constexpr double kUnitLength = 1e-6;   // how far a quaternion's length may be from 1

}  // namespace foothold::server::limits
