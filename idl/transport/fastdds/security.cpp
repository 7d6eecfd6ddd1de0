// As properties of the participant: names by Fast DDS.
#include "security.hpp"

#include "foothold/security/credentials.hpp"

namespace foothold::transport::fastdds {

void secure(eprosima::fastdds::dds::DomainParticipantQos& qos, const std::string& security) {
  auto& properties = qos.properties().properties();
  const auto set = [&](const std::string& name, const std::string& value) { properties.emplace_back(name, value); };
  const auto set_file = [&](const std::string& name, const std::string& path) { set(name, "file://" + path); };
  const foothold::security::CredentialFiles files = foothold::security::credential_files(security, "fastdds");
  set("dds.sec.auth.plugin", "builtin.PKI-DH");
  set_file("dds.sec.auth.builtin.PKI-DH.identity_ca", files.authority);
  set_file("dds.sec.auth.builtin.PKI-DH.identity_certificate", files.certificate);
  set_file("dds.sec.auth.builtin.PKI-DH.identity_crl", files.revoked);
  set_file("dds.sec.auth.builtin.PKI-DH.private_key", files.key);
  set("dds.sec.access.plugin", "builtin.Access-Permissions");
  set_file("dds.sec.access.builtin.Access-Permissions.permissions_ca", files.authority);
  set_file("dds.sec.access.builtin.Access-Permissions.governance", files.governance);
  set_file("dds.sec.access.builtin.Access-Permissions.permissions", files.permissions);
  set("dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC");
}

}  // namespace foothold::transport::fastdds
