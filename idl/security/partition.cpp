// Which partitions belong to whom.
#include <algorithm>

#include "foothold/security/credentials.hpp"

namespace foothold::security {
namespace {

constexpr std::size_t kPrefixOctets = 8;

msg::Id named(const std::string& name) { return msg::id_of("foothold client " + name); }

}  // namespace

std::string partition_prefix(const std::string& name) { return msg::to_hex(named(name)).substr(0, 2 * kPrefixOctets); }

msg::Id client_id(const std::string& name) {
  msg::Id id = msg::random_id();
  std::copy_n(named(name).begin(), kPrefixOctets, id.begin());
  return id;
}

bool is_id_of(const std::string& name, const msg::Id& id) {
  const msg::Id wanted = named(name);
  return std::equal(id.begin(), id.begin() + kPrefixOctets, wanted.begin());
}

}  // namespace foothold::security
