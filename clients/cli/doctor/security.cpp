// Whether DDS Security is on, and whether the credentials are in order.
#include <ctime>

#include "check.hpp"
#include "foothold/security/credentials.hpp"

namespace foothold::cli {
namespace {

using Level = Finding::Level;

constexpr std::int64_t kDay = 86400;
constexpr std::int64_t kSoon = 30;  // days

Finding check_credentials(const std::string& folder, const std::string& vendor) {
  const std::string subject = "credentials for " + vendor;
  try {
    const security::Credentials found = security::read_credentials(folder, vendor);
    const std::int64_t days = (found.expires - std::time(nullptr)) / kDay;
    const std::string message =
        folder + ": " + security::name_of(found.role) + " " + found.name + ", valid for " + std::to_string(days) + " days";
    if (days < kSoon) return {Level::kWarn, subject, message, "issue new ones: foothold security issue"};
    return {Level::kOk, subject, message, ""};
  } catch (const security::SecurityError& error) {
    return {Level::kFail, subject, error.what(), "without sound credentials nobody who has some speaks with this host"};
  }
}

}  // namespace

Findings check_security(const Common& common) {
  if (!common.security.empty())
    return {{Level::kOk, "DDS Security", "on, with the credentials in " + common.security, ""},
            check_credentials(common.security, "cyclone"),
            check_credentials(common.security, "fastdds")};
  const std::string who = common.network.empty() ? "every program on this host" : "whoever reaches the network";
  return {{Level::kWarn, "DDS Security",
           "off (no --security): " + who + " can submit and cancel requests, read everybody's plans and forge steps",
           "foothold security init, then issue credentials to the server (dds.security) and to each client (--security)"}};
}

}  // namespace foothold::cli
