// Credentials as a program reads them: what is wrong with them is told before a vendor sees them.
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "credentials.hpp"
#include "vendor_pairs.hpp"

namespace foothold::test {
namespace {

using namespace foothold::security;
namespace fs = std::filesystem;

class CredentialsOf : public testing::TestWithParam<std::string> {
 protected:
  std::string vendor() const { return GetParam(); }
  std::string own(const std::string& name) const { return folder_ + "/" + name; }
  void take(const std::string& from, const std::string& name) {
    fs::copy_file(from + "/" + name, own(name), fs::copy_options::overwrite_existing);
    if (name == "identity.key") fs::permissions(own(name), fs::perms(0600));
  }
  std::string complaint(Role role = Role::kClient) const {
    try {
      read_credentials(folder_, vendor(), role, "this program");
    } catch (const SecurityError& error) {
      return error.what();
    }
    return "none";
  }

  Fleet fleet_, foreign_;
  std::string folder_ = fleet_.issue("robot-7", Role::kClient);
};
INSTANTIATE_TEST_SUITE_P(Vendors, CredentialsOf, testing::ValuesIn(kVendors), vendor_name);

TEST_P(CredentialsOf, AreReadBackAsTheyWereIssued) {
  const Credentials read = read_credentials(folder_, vendor());
  EXPECT_EQ(read.name, "robot-7");
  EXPECT_EQ(read.role, Role::kClient);
  EXPECT_NEAR(static_cast<double>(read.expires - std::time(nullptr)), 365 * 86400.0, 60.0);
  EXPECT_EQ(complaint(), "none");
}

TEST_P(CredentialsOf, AnotherRoleAreRefused) {
  EXPECT_EQ(complaint(Role::kServer),
            folder_ + ": are the credentials of robot-7, for the role client; this program needs the role server");
}

TEST_P(CredentialsOf, WhoseKeyOthersMayReadAreRefused) {
  fs::permissions(own("identity.key"), fs::perms(0640));
  EXPECT_EQ(complaint(), own("identity.key") + ": others may read or change this private key; chmod 600 " + own("identity.key"));
}

TEST_P(CredentialsOf, WithPartsOfOthersAreRefused) {
  const std::string other = fleet_.issue("robot-8", Role::kClient);
  const std::string stranger = foreign_.issue("robot-7", Role::kClient);
  const std::string permissions = vendor() + "-permissions.p7s", certificate = vendor() + ".crt";
  const auto expect = [&](const std::string& from, const std::string& name, const std::string& words) {
    const std::string kept = own(name) + ".kept";
    fs::copy_file(own(name), kept);
    take(from, name);
    EXPECT_NE(complaint().find(words), std::string::npos) << name << ": " << complaint();
    fs::rename(kept, own(name));
    EXPECT_EQ(complaint(), "none");
  };
  expect(other, "identity.key", "is not the key of");
  expect(other, permissions, "is not for the holder of");
  expect(stranger, "authority.crt", "was not issued by the authority beside it");
  expect(stranger, permissions, "is not signed by the authority beside it");
  expect(stranger, "governance.p7s", "is not signed by the authority beside it");
  expect(stranger, "revoked.crl", "is not signed by the authority beside it");
}

TEST_P(CredentialsOf, TheOtherVendorAreRefused) {
  const std::string other = vendor() == "cyclone" ? "fastdds" : "cyclone";
  fs::copy_file(own(other + ".crt"), own(vendor() + ".crt"), fs::copy_options::overwrite_existing);
  EXPECT_NE(complaint().find("is not for " + vendor()), std::string::npos) << complaint();
}

TEST_P(CredentialsOf, WhosePermissionsWereChangedAreRefused) {
  std::ifstream in(own(vendor() + "-permissions.p7s"));
  std::ostringstream text;
  text << in.rdbuf();
  std::string changed = text.str();
  const std::string mine = "<partition>" + partition_prefix(read_credentials(folder_, vendor())) + "*";
  changed.replace(changed.find(mine), mine.size(), "<partition>*");
  std::ofstream(own(vendor() + "-permissions.p7s")) << changed;
  EXPECT_NE(complaint().find("was changed since"), std::string::npos) << complaint();
}

TEST_P(CredentialsOf, MissingFilesAreNamed) {
  for (const char* name : {"authority.crt", "governance.p7s", "identity.key", "revoked.crl"}) {
    fs::rename(own(name), own("away"));
    EXPECT_NE(complaint().find(own(name) + ": cannot be read"), std::string::npos) << complaint();
    fs::rename(own("away"), own(name));
  }
  folder_ += "-absent";
  EXPECT_NE(complaint().find("is no folder of credentials"), std::string::npos) << complaint();
}

TEST_P(CredentialsOf, GarbledFilesEndInAComplaint) {
  for (const std::string& name : {std::string("authority.crt"), std::string("governance.p7s"), std::string("identity.key"),
                                  std::string("revoked.crl"), vendor() + ".crt", vendor() + "-permissions.p7s"}) {
    std::ifstream in(own(name));
    std::ostringstream text;
    text << in.rdbuf();
    for (std::size_t at = 0; at + 2 < text.str().size(); at += 97) {
      std::string garbled = text.str();
      garbled[at] = static_cast<char>(garbled[at] ^ 0x15);
      std::ofstream(own(name)) << garbled;
      complaint();  // whatever it says, nothing else is thrown
      std::ofstream(own(name)) << garbled.substr(0, at);
      EXPECT_NE(complaint(), "none") << name << " cut at " << at;
    }
    std::ofstream(own(name)) << text.str();
    ASSERT_EQ(complaint(), "none");
  }
}

TEST_P(CredentialsOf, GiveClientsIdsThatBeginAlikeAndDiffer) {
  const Credentials mine = read_credentials(folder_, vendor());
  const Credentials others = read_credentials(fleet_.issue("robot-8", Role::kClient), vendor());
  const msg::Id first = client_id(mine), second = client_id(mine);
  EXPECT_NE(first, second);
  EXPECT_EQ(msg::to_hex(first).substr(0, 12), partition_prefix(mine));
  EXPECT_TRUE(is_id_of(mine, second));
  EXPECT_FALSE(is_id_of(others, second));
}

}  // namespace
}  // namespace foothold::test
