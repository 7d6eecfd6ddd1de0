// Which partitions belong to whom.
#include <algorithm>

#include "foothold/security/credentials.hpp"

namespace foothold::security {

std::string partition_prefix(const Credentials& credentials) {
  msg::Id id{};
  std::ranges::copy(credentials.sender, id.begin());
  return msg::to_hex(id).substr(0, 2 * credentials.sender.size());
}

msg::Id client_id(const Credentials& credentials) {
  msg::Id id = msg::random_id();
  std::ranges::copy(credentials.sender, id.begin());
  return id;
}

bool is_id_of(const Credentials& credentials, const msg::Id& id) {
  return std::equal(credentials.sender.begin(), credentials.sender.end(), id.begin());
}

}  // namespace foothold::security
