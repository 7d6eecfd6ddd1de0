// Words for the log.
#include "exposure.hpp"

#include <spdlog/spdlog.h>

#include <ctime>

#include "foothold/security/credentials.hpp"

namespace foothold::server {
namespace {

using foothold::security::Credentials;
using foothold::security::Role;

constexpr std::int64_t kDay = 86400;
constexpr std::int64_t kSoon = 30 * kDay;

Credentials credentials_of(const DdsConfig& dds) {
  return foothold::security::read_credentials(dds.security, dds.vendor, Role::kServer, "footholdd");
}

}  // namespace

std::string fault_of_security(const DdsConfig& dds) {
  if (dds.security.empty()) return {};
  try {
    credentials_of(dds);
  } catch (const foothold::security::SecurityError& error) {
    return error.what();
  }
  return {};
}

std::optional<std::int64_t> tell_exposure(const DdsConfig& dds) {
  if (dds.security.empty()) {
    spdlog::warn(
        "DDS Security is off: {} can submit and cancel requests, read everybody's plans and forge steps (dds.security)",
        dds.network_config.empty() ? "every program on this host" : "whoever reaches the network of " + dds.network_config);
    return std::nullopt;
  }
  const Credentials credentials = credentials_of(dds);
  const std::int64_t days = (credentials.expires - std::time(nullptr)) / kDay;
  spdlog::info("DDS Security is on, as {}; the credentials are valid for {} days", credentials.name, days);
  if (days * kDay < kSoon) spdlog::warn("the credentials in {} are over in {} days: issue new ones", dds.security, days);
  return credentials.expires;
}

}  // namespace foothold::server
