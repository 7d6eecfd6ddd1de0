// Points in time as text. Seconds since 1970; any thread.
#pragma once

#include <cstdint>
#include <string>

namespace foothold::msg {

// In universal time, as strftime() takes `format`; up to 63 characters.
std::string utc_text(std::int64_t seconds, const char* format);
// In the time of this place: "2026-11-22 23:59:59".
std::string local_text(std::int64_t seconds);

}  // namespace foothold::msg
