// Credentials: a folder that lets one program speak where DDS Security is on, made by `foothold security issue`. One folder serves
// both DDS vendors: what each needs is in it.
//
//   authority.crt            the certificate of the authority that made it, and signed all below
//   governance.p7s           what is encrypted and who is let in: the same for everybody
//   revoked.crl              certificates that are not valid any more; replace it when somebody was revoked
//   identity.key             the private key, readable by its owner alone
//   cyclone.crt, fastdds.crt                         the certificate for each vendor
//   cyclone-permissions.p7s, fastdds-permissions.p7s what its holder may read and write
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "foothold/msg/ids.hpp"
#include "foothold/security/error.hpp"

namespace foothold::security {

// A server serves; a client requests plans and reads its own; an observer reads everybody's plans and writes nothing.
enum class Role : std::uint8_t { kServer, kClient, kObserver };

const char* name_of(Role role);
// Throws SecurityError.
Role role_of(const std::string& name);

// Where things are, absolute. No file is touched.
struct CredentialFiles {
  std::string authority, governance, revoked, key, certificate, permissions;
};
// `vendor`: cyclone or fastdds.
CredentialFiles credential_files(const std::string& folder, const std::string& vendor);

struct Credentials {
  std::string name;  // of their holder
  Role role = Role::kClient;
  std::int64_t expires = 0;  // Unix time, s
  // With which the GUIDs of its holder's participants begin (transport::Sender): a digest of the certificate's subject.
  std::array<std::uint8_t, 6> sender{};
  CredentialFiles files;
};

// Reads the folder and refuses what a vendor would refuse in words that nobody understands, or would take though it should not: a
// file that is missing, a private key that others may read, a key or a signature that does not fit, a certificate that is not
// valid now or revoked, one that is not for this vendor. Throws SecurityError. Any thread.
Credentials read_credentials(const std::string& folder, const std::string& vendor);
// The same, and refuses those of another role. `program`: who asks, for the message.
Credentials read_credentials(const std::string& folder, const std::string& vendor, Role wanted, const std::string& program);

// A client's partition is its id; where security is on, an id begins with who its holder is to others (Credentials::sender): the
// permissions hold for partitions that begin so, and the server compares it with who sent the message. The rest is random: each
// program of a holder has a partition of its own.
// 12 hexadecimal digits.
std::string partition_prefix(const Credentials& credentials);
// A random id with that prefix.
msg::Id client_id(const Credentials& credentials);
bool is_id_of(const Credentials& credentials, const msg::Id& id);

}  // namespace foothold::security
