// Keys on the curve P-256 and certificates signed with ECDSA and SHA-256: what both vendors take.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "openssl.hpp"

namespace foothold::security {

struct Authority {
  Key key;
  Certificate certificate;
};

// Who a certificate is for. The role is read back from it, so the name in front says nothing by itself.
struct Subject {
  std::string name, role, vendor;
};

Key new_key();
std::string pem(EVP_PKEY* key);  // private
std::string pem(X509* certificate);
std::string pem(X509_CRL* revocations);
// `from` is for messages. Throw SecurityError.
Key key_from(const std::string& pem, const std::string& from);
Certificate certificate_from(const std::string& pem, const std::string& from);
Revocations revocations_from(const std::string& pem, const std::string& from);

// Valid from a day ago, so that a host whose clock is late takes it, until `seconds` from now.
Certificate authority_certificate(EVP_PKEY* key, double seconds);
// Not longer than the authority's. Throws SecurityError if that is over.
Certificate identity_certificate(const Authority& authority, EVP_PKEY* key, const Subject& subject, double seconds);

// Cyclone DDS 0.10 and Fast DDS 2.9 agree on a handshake only if Cyclone begins it, and the participant whose GUID is lower does.
// The GUID begins with the SHA-256 of the subject's DER: its first bit is 0 in our certificates for Cyclone and 1 in those for
// Fast.
std::array<std::uint8_t, 6> guid_prefix(X509* certificate);
bool fits_vendor(X509* certificate, const std::string& vendor);

// Throws SecurityError if it is not a subject as identity_certificate() makes them.
Subject subject_of(X509* certificate, const std::string& from);
// As permissions name it: RFC 2253.
std::string subject_text(X509* certificate);

std::int64_t unix_time(const ASN1_TIME* time);

// A list of none, or the old one with these certificates; valid as long as the authority, since a vendor takes nobody when it is
// over.
Revocations new_revocations(const Authority& authority);
Revocations with(const Authority& authority, X509_CRL* before, const std::vector<X509*>& certificates);
bool is_revoked(X509_CRL* revocations, X509* certificate);

}  // namespace foothold::security
