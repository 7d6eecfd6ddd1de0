// How a planner refuses a request. Apart from errors.hpp, which everybody includes: streams are heavy.
#pragma once

#include <sstream>

#include "foothold/errors.hpp"

namespace foothold {

// Throws InvalidRequest with a message made of the parts, as a stream writes them.
template <class... Parts>
[[noreturn]] void refuse_request(const std::string& field, const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  throw InvalidRequest(field, out.str());
}

}  // namespace foothold
