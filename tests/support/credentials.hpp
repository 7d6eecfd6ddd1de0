// An authority and everybody's credentials, made for the test and gone with it.
#pragma once

#include <string>

#include "foothold/security/authority.hpp"
#include "temporary_folder.hpp"

namespace foothold::test {

class Fleet {
 public:
  Fleet() { security::create_authority({.folder = authority()}); }
  std::string authority() const { return folder_ / "authority"; }
  // The folder of new credentials; each name once.
  std::string issue(const std::string& name, security::Role role) const {
    const std::string folder = folder_ / name;
    security::issue({.authority = authority(), .name = name, .role = role, .folder = folder});
    return folder;
  }

 private:
  TemporaryFolder folder_;
};

// An id that a client with these credentials may have.
inline msg::Id client_id(const std::string& folder, const std::string& vendor) {
  return security::client_id(security::read_credentials(folder, vendor));
}

}  // namespace foothold::test
