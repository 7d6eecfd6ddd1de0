// Authorities and what they issue: files, modes, subjects, and what is refused.
#include <gtest/gtest.h>
#include <openssl/pem.h>
#include <openssl/sha.h>
#include <openssl/x509.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "credentials.hpp"

namespace foothold::test {
namespace {

using namespace foothold::security;
namespace fs = std::filesystem;

unsigned mode(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 0777U;
}

std::string text(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream all;
  all << file.rdbuf();
  return all.str();
}

std::set<std::string> names(const std::string& folder) {
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) found.insert(entry.path().filename().string());
  return found;
}

// What the function complains of, or nothing.
template <class Work>
std::string complaint(Work work) {
  try {
    work();
  } catch (const SecurityError& error) {
    return error.what();
  }
  return {};
}

// The first 47 bits of the SHA-256 of the subject behind a first bit that is 1 begin the GUID: read here from the DER itself, with
// other functions than those that made it.
std::uint64_t guid_prefix(const std::string& certificate) {
  FILE* file = std::fopen(certificate.c_str(), "r");
  X509* read = PEM_read_X509(file, nullptr, nullptr, nullptr);
  std::fclose(file);
  unsigned char* der = nullptr;
  const int size = i2d_X509_NAME(X509_get_subject_name(read), &der);
  unsigned char digest[SHA256_DIGEST_LENGTH];
  SHA256(der, static_cast<std::size_t>(size), digest);
  OPENSSL_free(der);
  X509_free(read);
  std::uint64_t bits = 0;
  for (int i = 0; i < 6; ++i) bits = bits << 8U | digest[i];
  return (std::uint64_t{1} << 47U) | bits >> 1U;
}

TEST(Authority, KeepsItsKeysFromOthers) {
  const Fleet fleet;
  const std::string folder = fleet.issue("yard-1", Role::kServer);
  EXPECT_EQ(mode(fleet.authority()), 0700U);
  EXPECT_EQ(mode(fleet.authority() + "/authority.key"), 0600U);
  EXPECT_EQ(mode(folder), 0700U);
  EXPECT_EQ(mode(folder + "/identity.key"), 0600U);
  EXPECT_EQ(names(folder),
            (std::set<std::string>{"authority.crt", "cyclone-permissions.p7s", "cyclone.crt", "fastdds-permissions.p7s",
                                   "fastdds.crt", "governance.p7s", "identity.key", "revoked.crl"}));
  for (const std::string& name : names(folder)) {
    if (name != "identity.key") {
      EXPECT_EQ(text(folder + "/" + name).find("PRIVATE KEY"), std::string::npos) << name;
    }
  }
}

// Whichever two of a fleet meet, the one on Cyclone has the lower GUID and begins the handshake.
TEST(Authority, PutsEveryCertificateForCycloneBelowEveryOneForFastDds) {
  const Fleet fleet;
  std::uint64_t highest_cyclone = 0, lowest_fast = ~std::uint64_t{0};
  for (int i = 0; i < 20; ++i) {
    const std::string folder = fleet.issue("robot-" + std::to_string(i), i % 2 == 0 ? Role::kClient : Role::kObserver);
    highest_cyclone = std::max(highest_cyclone, guid_prefix(folder + "/cyclone.crt"));
    lowest_fast = std::min(lowest_fast, guid_prefix(folder + "/fastdds.crt"));
    for (const char* vendor : {"cyclone", "fastdds"}) {
      char prefix[13] = {};
      std::snprintf(prefix, sizeof prefix, "%012llx", static_cast<unsigned long long>(guid_prefix(folder + "/" + vendor + ".crt")));
      EXPECT_EQ(partition_prefix(read_credentials(folder, vendor)), prefix);
    }
  }
  EXPECT_LT(highest_cyclone, lowest_fast);
}

TEST(Authority, PermitsEachRoleItsTopicsAndPartitions) {
  const Fleet fleet;
  const std::string folder = fleet.issue("robot-7", Role::kClient);
  const std::string client = text(folder + "/cyclone-permissions.p7s");
  const std::string observer = text(fleet.issue("viewer", Role::kObserver) + "/cyclone-permissions.p7s");
  const std::string server = text(fleet.issue("yard-1", Role::kServer) + "/cyclone-permissions.p7s");
  EXPECT_NE(client.find("<partition>" + partition_prefix(read_credentials(folder, "cyclone")) + "*</partition>"),
            std::string::npos);
  EXPECT_EQ(client.find("<partition>*</partition>"), std::string::npos);
  EXPECT_EQ(observer.find("<publish>"), std::string::npos);
  EXPECT_NE(observer.find("<partition>*</partition>"), std::string::npos);
  EXPECT_NE(server.find("<publish>"), std::string::npos);
  for (const std::string& document : {client, observer, server})
    EXPECT_NE(document.find("<default>DENY</default>"), std::string::npos);
}

TEST(Authority, OverwritesNothing) {
  const Fleet fleet;
  const std::string key = text(fleet.authority() + "/authority.key");
  EXPECT_NE(complaint([&] { create_authority({.folder = fleet.authority()}); }).find("nothing is overwritten"), std::string::npos);
  EXPECT_EQ(text(fleet.authority() + "/authority.key"), key);
  const std::string folder = fleet.issue("yard-1", Role::kServer);
  const NewCredentials into_it{.authority = fleet.authority(), .name = "yard-2", .role = Role::kServer, .folder = folder};
  EXPECT_NE(complaint([&] { issue(into_it); }).find("nothing is overwritten"), std::string::npos);
  const NewCredentials again{.authority = fleet.authority(), .name = "yard-1", .role = Role::kClient, .folder = folder + "-again"};
  EXPECT_NE(complaint([&] { issue(again); }).find("'yard-1' has credentials already"), std::string::npos);
  EXPECT_FALSE(fs::exists(again.folder));
}

TEST(Authority, RefusesNamesAndTimesThatAreNone) {
  const Fleet fleet;
  const auto with = [&](const std::string& name, double days) {
    return complaint([&] {
      issue(
          {.authority = fleet.authority(), .name = name, .role = Role::kClient, .folder = fleet.authority() + "-x", .days = days});
    });
  };
  for (const char* name : {"", "a/b", "..", "-x", "a b", "a,b", "<x>"})
    EXPECT_NE(with(name, 1).find("is no name"), std::string::npos) << name;
  EXPECT_NE(with(std::string(49, 'a'), 1).find("is no name"), std::string::npos);
  EXPECT_EQ(with("a", 0), "days must be above 0 and 36500 at most");
  EXPECT_EQ(with("a", -1), "days must be above 0 and 36500 at most");
  EXPECT_NE(complaint([&] { issue({.authority = "/nowhere", .name = "a", .folder = "/nowhere/a"}); }).find("is no authority"),
            std::string::npos);
}

TEST(Authority, IssuesANameAgainOnceItIsRevoked) {
  const Fleet fleet;
  const std::string before = fleet.issue("robot-7", Role::kClient);
  EXPECT_EQ(complaint([&] { revoke(fleet.authority(), "robot-8"); }), "'robot-8' was never issued by " + fleet.authority());
  revoke(fleet.authority(), "robot-7");
  EXPECT_EQ(complaint([&] { revoke(fleet.authority(), "robot-7"); }), "'robot-7' is revoked already");
  EXPECT_TRUE(list_issued(fleet.authority()).at(0).revoked);
  const std::string after = before + "-again";
  issue({.authority = fleet.authority(), .name = "robot-7", .role = Role::kClient, .folder = after});
  EXPECT_FALSE(list_issued(fleet.authority()).at(0).revoked);
  for (const char* vendor : {"cyclone", "fastdds"}) {
    EXPECT_EQ(read_credentials(after, vendor).name, "robot-7");
    fs::copy_file(after + "/revoked.crl", before + "/revoked.crl", fs::copy_options::overwrite_existing);
    EXPECT_NE(complaint([&] { read_credentials(before, vendor); }).find("is revoked"), std::string::npos);
  }
}

}  // namespace
}  // namespace foothold::test
