// The authority's folder: made, used and kept.
#include "foothold/security/authority.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "documents.hpp"
#include "files.hpp"
#include "signing.hpp"

namespace foothold::security {
namespace fs = std::filesystem;

namespace {

constexpr double kDay = 86400.0;
constexpr const char* kVendors[] = {"cyclone", "fastdds"};
constexpr std::size_t kLongestName = 48;

struct Open {
  Authority authority;
  Revocations revoked;
  std::string certificate, governance, revocations;  // as they are in their files
};

Open open(const fs::path& folder) {
  const fs::path key = folder / "authority.key";
  std::error_code fault;
  if (!fs::exists(key, fault))
    throw SecurityError(folder.string() + ": is no authority; make one by 'foothold security init " + folder.string() + "'");
  Open found;
  found.certificate = read_file(folder / "authority.crt");
  found.governance = read_file(folder / "governance.p7s");
  found.revocations = read_file(folder / "revoked.crl");
  found.authority = {key_from(read_file(key), key.string()),
                     certificate_from(found.certificate, (folder / "authority.crt").string())};
  found.revoked = revocations_from(found.revocations, (folder / "revoked.crl").string());
  if (X509_check_private_key(found.authority.certificate.get(), found.authority.key.get()) != 1)
    throw failure(key.string() + ": is not the key of authority.crt");
  return found;
}

void refuse_bad_name(const std::string& name) {
  const bool fine =
      !name.empty() && name.size() <= kLongestName && name[0] != '.' && name[0] != '-' &&
      name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-") == std::string::npos;
  if (!fine)
    throw SecurityError("'" + name + "' is no name: 1 to 48 of A-Z a-z 0-9 . _ - are, and the first is a letter, a digit or _");
}

void refuse_bad_time(double value, const char* what) {
  if (!(std::isfinite(value) && value > 0.0 && value <= 36500.0))
    throw SecurityError(std::string(what) + " must be above 0 and 36500 at most");
}

fs::path kept(const fs::path& folder, const std::string& name, const std::string& vendor) {
  return folder / "issued" / (name + "." + vendor + ".crt");
}

Certificate kept_certificate(const fs::path& folder, const std::string& name, const std::string& vendor) {
  const fs::path path = kept(folder, name, vendor);
  return certificate_from(read_file(path), path.string());
}

}  // namespace

void create_authority(const NewAuthority& wanted) {
  refuse_bad_time(wanted.years, "years");
  const fs::path folder = wanted.folder;
  make_private_folder(folder);
  Unfinished unfinished(folder);
  Authority authority{new_key(), nullptr};
  authority.certificate = authority_certificate(authority.key.get(), wanted.years * 365.25 * kDay);
  make_private_folder(folder / "issued");
  write_new(folder / "authority.key", pem(authority.key.get()), Access::kOwner);
  write_new(folder / "authority.crt", pem(authority.certificate.get()), Access::kEverybody);
  write_new(folder / "governance.p7s", sign(authority, governance_document()), Access::kEverybody);
  write_new(folder / "revoked.crl", pem(new_revocations(authority).get()), Access::kEverybody);
  unfinished.keep();
}

void issue(const NewCredentials& wanted) {
  refuse_bad_name(wanted.name);
  refuse_bad_time(wanted.days, "days");
  const fs::path home = wanted.authority;
  const Open from = open(home);
  for (const char* vendor : kVendors) {
    std::error_code fault;
    if (!fs::exists(kept(home, wanted.name, vendor), fault)) continue;
    if (is_revoked(from.revoked.get(), kept_certificate(home, wanted.name, vendor).get())) continue;
    throw SecurityError("'" + wanted.name + "' has credentials already; revoke them by 'foothold security revoke " + wanted.name +
                        "', or choose another name");
  }
  const fs::path folder = wanted.folder;
  make_private_folder(folder);
  Unfinished unfinished(folder);
  const Key key = new_key();
  write_new(folder / "identity.key", pem(key.get()), Access::kOwner);
  write_new(folder / "authority.crt", from.certificate, Access::kEverybody);
  write_new(folder / "governance.p7s", from.governance, Access::kEverybody);
  write_new(folder / "revoked.crl", from.revocations, Access::kEverybody);
  std::map<std::string, std::string> certificates;
  for (const char* vendor : kVendors) {
    const Subject subject{wanted.name, name_of(wanted.role), vendor};
    const Certificate certificate = identity_certificate(from.authority, key.get(), subject, wanted.days * kDay);
    const CredentialFiles files = credential_files(folder.string(), vendor);
    write_new(files.certificate, certificates[vendor] = pem(certificate.get()), Access::kEverybody);
    Credentials holder;
    holder.sender = guid_prefix(certificate.get());
    const Grant grant{wanted.name,
                      subject_text(certificate.get()),
                      wanted.role,
                      partition_prefix(holder),
                      unix_time(X509_get0_notBefore(certificate.get())),
                      unix_time(X509_get0_notAfter(certificate.get()))};
    write_new(files.permissions, sign(from.authority, permissions_document(grant)), Access::kEverybody);
  }
  // Last, when nothing can fail but this: what is in the books was given out.
  for (const char* vendor : kVendors) replace(kept(home, wanted.name, vendor), certificates[vendor], Access::kEverybody);
  unfinished.keep();
}

void revoke(const std::string& authority, const std::string& name) {
  refuse_bad_name(name);
  const fs::path home = authority;
  const Open from = open(home);
  std::vector<Certificate> certificates;
  std::vector<X509*> valid;
  for (const char* vendor : kVendors) {
    std::error_code fault;
    if (!fs::exists(kept(home, name, vendor), fault)) throw SecurityError("'" + name + "' was never issued by " + authority);
    certificates.push_back(kept_certificate(home, name, vendor));
    if (!is_revoked(from.revoked.get(), certificates.back().get())) valid.push_back(certificates.back().get());
  }
  if (valid.empty()) throw SecurityError("'" + name + "' is revoked already");
  replace(home / "revoked.crl", pem(with(from.authority, from.revoked.get(), valid).get()), Access::kEverybody);
}

std::vector<Issued> list_issued(const std::string& authority) {
  const fs::path home = authority;
  const Open from = open(home);
  const std::string ending = std::string(".") + kVendors[0] + ".crt";
  std::vector<Issued> all;
  for (const auto& entry : fs::directory_iterator(home / "issued")) {
    const std::string file = entry.path().filename().string();
    if (!file.ends_with(ending)) continue;
    const std::string name = file.substr(0, file.size() - ending.size());
    const Certificate certificate = kept_certificate(home, name, kVendors[0]);
    all.push_back({name, role_of(subject_of(certificate.get(), file).role), unix_time(X509_get0_notAfter(certificate.get())),
                   is_revoked(from.revoked.get(), certificate.get())});
  }
  std::ranges::sort(all, {}, &Issued::name);
  return all;
}

}  // namespace foothold::security
