// Calendar times by the C library's reentrant functions.
#include "foothold/msg/times.hpp"

#include <ctime>

namespace foothold::msg {
namespace {

std::string text_of(const std::tm& parts, const char* format) {
  char text[64] = {};
  std::strftime(text, sizeof text, format, &parts);
  return text;
}

}  // namespace

std::string utc_text(std::int64_t seconds, const char* format) {
  const std::time_t time = seconds;
  std::tm parts{};
  gmtime_r(&time, &parts);
  return text_of(parts, format);
}

std::string local_text(std::int64_t seconds) {
  const std::time_t time = seconds;
  std::tm parts{};
  localtime_r(&time, &parts);
  return text_of(parts, "%Y-%m-%d %H:%M:%S");
}

}  // namespace foothold::msg
