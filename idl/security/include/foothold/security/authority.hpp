// The authority of a fleet: a folder with the key that signs every certificate and permission. Whoever has it can make himself
// anything, so it stays on the operators' machine and never on a robot's.
//
//   authority.key   private key, 0600; the folder is 0700
//   authority.crt   its certificate
//   governance.p7s  what is encrypted and who is let in
//   revoked.crl     certificates that are not valid any more
//   issued/         NAME.cyclone.crt and NAME.fastdds.crt, so that NAME can be revoked
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "foothold/security/credentials.hpp"

namespace foothold::security {

struct NewAuthority {
  std::string folder;   // made; must not be there, or be empty
  double years = 10.0;  // valid for so long
};

struct NewCredentials {
  std::string authority;  // its folder
  std::string name;       // 1 to 48 of A-Z a-z 0-9 . _ -
  Role role = Role::kClient;
  std::string folder;   // made; must not be there, or be empty
  double days = 365.0;  // valid for so long, and not longer than the authority
};

// All of them throw SecurityError, and leave nothing half made in a folder that was there before. Nothing is ever overwritten but
// revoked.crl, by another that says more.
void create_authority(const NewAuthority& wanted);
// Refuses a name that was issued before and not revoked.
void issue(const NewCredentials& wanted);
// Adds the certificates of `name` to revoked.crl. It holds wherever that file is put and the program is started anew.
void revoke(const std::string& authority, const std::string& name);

struct Issued {
  std::string name;
  Role role;
  std::int64_t expires;  // Unix time, s
  bool revoked;
};
// Everybody who was ever given credentials, by name.
std::vector<Issued> list_issued(const std::string& authority);

}  // namespace foothold::security
