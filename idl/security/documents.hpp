// Governance and permissions as XML (OMG DDS Security 1.1, 9.4.1.2 and 9.4.1.3), before they are signed.
#pragma once

#include <cstdint>
#include <string>

#include "foothold/security/credentials.hpp"

namespace foothold::security {

// What holds for everybody: who is not in the authority's books does not get in; discovery, liveliness and every message are
// encrypted; each topic is read and written by permission only. (Not the RTPS messages as a whole: Fast DDS 2.9 aborts on those.)
std::string governance_document();

struct Grant {
  std::string holder;   // name
  std::string subject;  // of the certificate, RFC 2253
  Role role;
  std::string prefix;            // of a client's partitions
  std::int64_t begins, expires;  // Unix time, s
};
// What one holder may read and write; all else is denied.
std::string permissions_document(const Grant& grant);

}  // namespace foothold::security
