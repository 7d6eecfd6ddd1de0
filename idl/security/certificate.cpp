// Certificates by OpenSSL's library.
#include "certificate.hpp"

#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <array>
#include <ctime>

namespace foothold::security {
namespace {

constexpr long kDay = 86400;
constexpr const char* kOrganization = "foothold";

std::string random_hex(std::size_t octets) {
  std::string text;
  for (std::size_t i = 0; i < octets; ++i) {
    unsigned char octet = 0;
    must(RAND_bytes(&octet, 1) == 1, "no random numbers");
    text += "0123456789abcdef"[octet >> 4U];
    text += "0123456789abcdef"[octet & 15U];
  }
  return text;
}

void add(X509_NAME* name, const char* field, const std::string& value) {
  must(
      X509_NAME_add_entry_by_txt(name, field, MBSTRING_UTF8, reinterpret_cast<const unsigned char*>(value.c_str()), -1, -1, 0) == 1,
      "name");
}

void set_serial(X509* certificate) {
  std::array<unsigned char, 16> octets;
  must(RAND_bytes(octets.data(), static_cast<int>(octets.size())) == 1, "no random numbers");
  octets[0] = static_cast<unsigned char>((octets[0] & 0x7fU) | 0x40U);  // positive, and of full length
  BIGNUM* number = BN_bin2bn(octets.data(), static_cast<int>(octets.size()), nullptr);
  const bool fine = number != nullptr && BN_to_ASN1_INTEGER(number, X509_get_serialNumber(certificate)) != nullptr;
  BN_free(number);
  must(fine, "serial number");
}

void extend(X509* certificate, X509* issuer, int what, const char* value) {
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, issuer, certificate, nullptr, nullptr, 0);
  X509_EXTENSION* extension = X509V3_EXT_conf_nid(nullptr, &context, what, value);
  const bool fine = extension != nullptr && X509_add_ext(certificate, extension, -1) == 1;
  X509_EXTENSION_free(extension);
  must(fine, "extension");
}

Certificate begun(EVP_PKEY* key) {
  Certificate certificate(X509_new());
  must(certificate != nullptr, "no memory");
  must(X509_set_version(certificate.get(), 2) == 1, "version");
  set_serial(certificate.get());
  must(X509_gmtime_adj(X509_getm_notBefore(certificate.get()), -kDay) != nullptr, "time");
  must(X509_set_pubkey(certificate.get(), key) == 1, "key");
  return certificate;
}

Name name_of(const Subject& subject) {
  Name name(X509_NAME_new());
  must(name != nullptr, "no memory");
  add(name.get(), "O", kOrganization);
  add(name.get(), "OU", subject.role + "-" + subject.vendor + "-" + random_hex(4));
  add(name.get(), "CN", subject.name);
  return name;
}

std::array<unsigned char, EVP_MAX_MD_SIZE> digest_of(const X509_NAME* name) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned size = 0;
  must(X509_NAME_digest(name, EVP_sha256(), digest.data(), &size) == 1, "digest");
  return digest;
}

bool first_bit(const X509_NAME* name) { return (digest_of(name)[0] & 0x80U) != 0; }

bool wanted_bit(const std::string& vendor) { return vendor == "fastdds"; }

std::string entry(X509_NAME* name, int what) {
  const int at = X509_NAME_get_index_by_NID(name, what, -1);
  if (at < 0) return {};
  const ASN1_STRING* text = X509_NAME_ENTRY_get_data(X509_NAME_get_entry(name, at));
  return {reinterpret_cast<const char*>(ASN1_STRING_get0_data(text)), static_cast<std::size_t>(ASN1_STRING_length(text))};
}

Revocations signed_list(const Authority& authority, Revocations list) {
  must(X509_CRL_set_version(list.get(), 1) == 1, "version");
  must(X509_CRL_set_issuer_name(list.get(), X509_get_subject_name(authority.certificate.get())) == 1, "name");
  const Moment since(X509_gmtime_adj(nullptr, -kDay));
  must(since && X509_CRL_set1_lastUpdate(list.get(), since.get()) == 1, "time");
  must(X509_CRL_set1_nextUpdate(list.get(), X509_get0_notAfter(authority.certificate.get())) == 1, "time");
  must(X509_CRL_sort(list.get()) == 1, "order");
  must(X509_CRL_sign(list.get(), authority.key.get(), EVP_sha256()) > 0, "signature");
  return list;
}

}  // namespace

Key new_key() {
  Key key(EVP_EC_gen("P-256"));
  must(key != nullptr, "key");
  return key;
}

std::string pem(EVP_PKEY* key) {
  const Bio out = memory();
  must(PEM_write_bio_PrivateKey(out.get(), key, nullptr, nullptr, 0, nullptr, nullptr) == 1, "key");
  return text_of(out.get());
}

std::string pem(X509* certificate) {
  const Bio out = memory();
  must(PEM_write_bio_X509(out.get(), certificate) == 1, "certificate");
  return text_of(out.get());
}

std::string pem(X509_CRL* revocations) {
  const Bio out = memory();
  must(PEM_write_bio_X509_CRL(out.get(), revocations) == 1, "revocations");
  return text_of(out.get());
}

Key key_from(const std::string& pem, const std::string& from) {
  Key key(PEM_read_bio_PrivateKey(memory(pem).get(), nullptr, nullptr, nullptr));
  if (!key) throw failure(from + ": is no private key");
  return key;
}

Certificate certificate_from(const std::string& pem, const std::string& from) {
  Certificate certificate(PEM_read_bio_X509(memory(pem).get(), nullptr, nullptr, nullptr));
  if (!certificate) throw failure(from + ": is no certificate");
  return certificate;
}

Revocations revocations_from(const std::string& pem, const std::string& from) {
  Revocations revocations(PEM_read_bio_X509_CRL(memory(pem).get(), nullptr, nullptr, nullptr));
  if (!revocations) throw failure(from + ": is no list of revoked certificates");
  return revocations;
}

Certificate authority_certificate(EVP_PKEY* key, double seconds) {
  Certificate certificate = begun(key);
  X509* raw = certificate.get();
  must(X509_gmtime_adj(X509_getm_notAfter(raw), static_cast<long>(seconds)) != nullptr, "time");
  Name name(X509_NAME_new());
  add(name.get(), "O", kOrganization);
  add(name.get(), "CN", "authority-" + random_hex(4));
  must(X509_set_subject_name(raw, name.get()) == 1 && X509_set_issuer_name(raw, name.get()) == 1, "name");
  extend(raw, raw, NID_basic_constraints, "critical,CA:TRUE,pathlen:0");
  // It signs the documents, too.
  extend(raw, raw, NID_key_usage, "critical,digitalSignature,keyCertSign,cRLSign");
  extend(raw, raw, NID_subject_key_identifier, "hash");
  must(X509_sign(raw, key, EVP_sha256()) > 0, "signature");
  return certificate;
}

Certificate identity_certificate(const Authority& authority, EVP_PKEY* key, const Subject& subject, double seconds) {
  Certificate certificate = begun(key);
  X509* raw = certificate.get();
  const ASN1_TIME* last = X509_get0_notAfter(authority.certificate.get());
  const Moment wanted(X509_gmtime_adj(nullptr, static_cast<long>(seconds)));
  if (X509_cmp_current_time(last) < 0) throw SecurityError("the authority's own certificate is over; make a new authority");
  must(X509_set1_notAfter(raw, ASN1_TIME_compare(wanted.get(), last) > 0 ? last : wanted.get()) == 1, "time");
  Name name = name_of(subject);
  while (first_bit(name.get()) != wanted_bit(subject.vendor)) name = name_of(subject);
  must(X509_set_subject_name(raw, name.get()) == 1, "name");
  must(X509_set_issuer_name(raw, X509_get_subject_name(authority.certificate.get())) == 1, "name");
  extend(raw, authority.certificate.get(), NID_basic_constraints, "critical,CA:FALSE");
  extend(raw, authority.certificate.get(), NID_key_usage, "critical,digitalSignature");
  extend(raw, authority.certificate.get(), NID_authority_key_identifier, "keyid:always");
  must(X509_sign(raw, authority.key.get(), EVP_sha256()) > 0, "signature");
  return certificate;
}

// A bit that is 1, then the first 47 of the digest (DDS Security 1.1, 9.3.3).
std::array<std::uint8_t, 6> guid_prefix(X509* certificate) {
  const auto digest = digest_of(X509_get_subject_name(certificate));
  std::array<std::uint8_t, 6> prefix{};
  unsigned above = 1;
  for (std::size_t i = 0; i < prefix.size(); ++i) {
    prefix[i] = static_cast<std::uint8_t>(above << 7U | digest[i] >> 1U);
    above = digest[i] & 1U;
  }
  return prefix;
}

bool fits_vendor(X509* certificate, const std::string& vendor) {
  return first_bit(X509_get_subject_name(certificate)) == wanted_bit(vendor);
}

Subject subject_of(X509* certificate, const std::string& from) {
  X509_NAME* name = X509_get_subject_name(certificate);
  const std::string unit = entry(name, NID_organizationalUnitName);
  const std::size_t first = unit.find('-');
  const std::size_t second = first == std::string::npos ? first : unit.find('-', first + 1);
  if (second == std::string::npos)
    throw SecurityError(from + ": its subject '" + subject_text(certificate) + "' is not as 'foothold security issue' makes them");
  return {entry(name, NID_commonName), unit.substr(0, first), unit.substr(first + 1, second - first - 1)};
}

std::string subject_text(X509* certificate) {
  const Bio out = memory();
  must(X509_NAME_print_ex(out.get(), X509_get_subject_name(certificate), 0, XN_FLAG_RFC2253) >= 0, "name");
  return text_of(out.get());
}

std::int64_t unix_time(const ASN1_TIME* time) {
  std::tm parts{};
  must(ASN1_TIME_to_tm(time, &parts) == 1, "time");
  return timegm(&parts);
}

Revocations new_revocations(const Authority& authority) {
  Revocations list(X509_CRL_new());
  must(list != nullptr, "no memory");
  return signed_list(authority, std::move(list));
}

Revocations with(const Authority& authority, X509_CRL* before, const std::vector<X509*>& certificates) {
  Revocations list(X509_CRL_dup(before));
  must(list != nullptr, "no memory");
  for (X509* certificate : certificates) {
    X509_REVOKED* entry = X509_REVOKED_new();
    const Moment now(X509_gmtime_adj(nullptr, 0));
    const bool fine = entry != nullptr && X509_REVOKED_set_serialNumber(entry, X509_get_serialNumber(certificate)) == 1 &&
                      X509_REVOKED_set_revocationDate(entry, now.get()) == 1 && X509_CRL_add0_revoked(list.get(), entry) == 1;
    if (!fine) X509_REVOKED_free(entry);
    must(fine, "revocation");
  }
  return signed_list(authority, std::move(list));
}

bool is_revoked(X509_CRL* revocations, X509* certificate) {
  X509_REVOKED* found = nullptr;
  return X509_CRL_get0_by_serial(revocations, &found, X509_get_serialNumber(certificate)) != 0;
}

}  // namespace foothold::security
