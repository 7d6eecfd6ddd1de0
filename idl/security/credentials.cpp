// Looks at credentials before a vendor does.
#include "foothold/security/credentials.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>

#include "certificate.hpp"
#include "files.hpp"
#include "foothold/msg/times.hpp"
#include "signing.hpp"

namespace foothold::security {
namespace fs = std::filesystem;

namespace {

struct RoleName {
  Role role;
  const char* name;
};
constexpr RoleName kRoles[] = {{Role::kServer, "server"}, {Role::kClient, "client"}, {Role::kObserver, "observer"}};

constexpr const char* kDay = "%Y-%m-%d";

// A key of the superuser's may be readable for a group: that is how systemd hands credentials to a service (as an ACL).
void refuse_open_key(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return;  // reading it tells why
  const bool handed_over = status.st_uid == 0 && ::geteuid() != 0;
  if ((status.st_mode & (handed_over ? 037U : 077U)) != 0)
    throw SecurityError(path + ": others may read or change this private key; chmod 600 " + path);
}

void refuse_wrong_time(X509* certificate, const std::string& path) {
  if (X509_cmp_current_time(X509_get0_notBefore(certificate)) > 0)
    throw SecurityError(path + ": is not valid before " + msg::utc_text(unix_time(X509_get0_notBefore(certificate)), kDay) +
                        "; is this host's clock right?");
  if (X509_cmp_current_time(X509_get0_notAfter(certificate)) < 0)
    throw SecurityError(path + ": is over since " + msg::utc_text(unix_time(X509_get0_notAfter(certificate)), kDay) +
                        "; issue new credentials");
}

}  // namespace

const char* name_of(Role role) {
  for (const RoleName& each : kRoles)
    if (each.role == role) return each.name;
  return "";
}

Role role_of(const std::string& name) {
  for (const RoleName& each : kRoles)
    if (each.name == name) return each.role;
  throw SecurityError("'" + name + "' is no role; known are server, client and observer");
}

CredentialFiles credential_files(const std::string& folder, const std::string& vendor) {
  std::error_code fault;
  fs::path at = fs::absolute(folder, fault);
  if (fault) at = folder;
  return {(at / "authority.crt").string(), (at / "governance.p7s").string(),  (at / "revoked.crl").string(),
          (at / "identity.key").string(),  (at / (vendor + ".crt")).string(), (at / (vendor + "-permissions.p7s")).string()};
}

Credentials read_credentials(const std::string& folder, const std::string& vendor) {
  std::error_code fault;
  if (!fs::is_directory(folder, fault))
    throw SecurityError(folder + ": is no folder of credentials; make one by 'foothold security issue'");
  Credentials credentials;
  const CredentialFiles& files = credentials.files = credential_files(folder, vendor);
  refuse_open_key(files.key);
  const Certificate authority = certificate_from(read_file(files.authority), files.authority);
  const Certificate certificate = certificate_from(read_file(files.certificate), files.certificate);
  const Key key = key_from(read_file(files.key), files.key);
  if (X509_check_private_key(certificate.get(), key.get()) != 1)
    throw failure(files.key + ": is not the key of " + files.certificate);
  verify(authority.get(), certificate.get(), files.certificate);
  refuse_wrong_time(authority.get(), files.authority);
  refuse_wrong_time(certificate.get(), files.certificate);
  const Subject subject = subject_of(certificate.get(), files.certificate);
  if (subject.vendor != vendor || !fits_vendor(certificate.get(), vendor))
    throw SecurityError(files.certificate + ": is not for " + vendor + "; the handshake of the vendors would fail");
  verified(authority.get(), read_file(files.governance), files.governance);
  const std::string permissions = verified(authority.get(), read_file(files.permissions), files.permissions);
  if (permissions.find("<subject_name>" + subject_text(certificate.get()) + "</subject_name>") == std::string::npos)
    throw SecurityError(files.permissions + ": is not for the holder of " + files.certificate);
  const Revocations revoked = revocations_from(read_file(files.revoked), files.revoked);
  if (X509_CRL_verify(revoked.get(), X509_get0_pubkey(authority.get())) != 1)
    throw failure(files.revoked + ": is not signed by the authority beside it");
  if (is_revoked(revoked.get(), certificate.get()))
    throw SecurityError(files.certificate + ": is revoked; ask for new credentials");
  credentials.name = subject.name;
  credentials.sender = guid_prefix(certificate.get());
  credentials.role = role_of(subject.role);
  credentials.expires = unix_time(X509_get0_notAfter(certificate.get()));
  return credentials;
}

Credentials read_credentials(const std::string& folder, const std::string& vendor, Role wanted, const std::string& program) {
  Credentials credentials = read_credentials(folder, vendor);
  if (credentials.role != wanted)
    throw SecurityError(folder + ": are the credentials of " + credentials.name + ", for the role " + name_of(credentials.role) +
                        "; " + program + " needs the role " + name_of(wanted));
  return credentials;
}

}  // namespace foothold::security
