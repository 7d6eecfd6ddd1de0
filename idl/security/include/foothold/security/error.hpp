// What is wrong with keys, certificates and signed documents.
#pragma once

#include <stdexcept>

namespace foothold::security {

// The message names the file and says what to do.
class SecurityError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace foothold::security
