// As properties of the participant: names by DDS Security 1.1, and by Cyclone for the libraries and the list of revoked ones.
#include "security.hpp"

#include "foothold/security/credentials.hpp"

namespace foothold::transport::cyclone {

Qos participant_qos(const std::string& security) {
  Qos qos(dds_create_qos());
  if (security.empty()) return qos;
  const auto set = [&](const std::string& name, const std::string& value) {
    dds_qset_prop(qos.get(), name.c_str(), value.c_str());
  };
  const auto set_library = [&](const std::string& part, const std::string& library, const std::string& function) {
    set("dds.sec." + part + ".library.path", library);
    set("dds.sec." + part + ".library.init", "init_" + function);
    set("dds.sec." + part + ".library.finalize", "finalize_" + function);
  };
  set_library("auth", "dds_security_auth", "authentication");
  set_library("access", "dds_security_ac", "access_control");
  set_library("crypto", "dds_security_crypto", "crypto");
  const foothold::security::CredentialFiles files = foothold::security::credential_files(security, "cyclone");
  const auto set_file = [&](const char* name, const std::string& path) { set(name, "file://" + path); };
  set_file("dds.sec.auth.identity_ca", files.authority);
  set_file("dds.sec.auth.identity_certificate", files.certificate);
  set_file("dds.sec.auth.private_key", files.key);
  set_file("org.eclipse.cyclonedds.sec.auth.crl", files.revoked);
  set_file("dds.sec.access.permissions_ca", files.authority);
  set_file("dds.sec.access.governance", files.governance);
  set_file("dds.sec.access.permissions", files.permissions);
  return qos;
}

}  // namespace foothold::transport::cyclone
