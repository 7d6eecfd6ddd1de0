// Whether the vendors' libraries load, and who answers through them.
#include <algorithm>

#include "check.hpp"
#include "connection.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

using Level = Finding::Level;

constexpr double kMostPatience = 3.0;  // s for each vendor

Finding judge(const std::string& subject, const client::ServerSeen& server) {
  const msg::ServerInfo& info = server.info;
  const std::string who = printable(info.name()) + " " + printable(info.version());
  if (info.protocol() != msg::PROTOCOL_VERSION)
    return {Level::kFail, subject,
            format("%s speaks protocol %u, this program %u", who.c_str(), info.protocol(), msg::PROTOCOL_VERSION),
            "install the same version of both"};
  if (info.stopping()) return {Level::kWarn, subject, who + " is stopping and takes no requests", "wait until it is back"};
  return {Level::kOk, subject,
          format("%s answers; %u of %u slots busy, %u waiting", who.c_str(), info.running(), info.slots(), info.queued()), ""};
}

Findings check_vendor(Common common) {
  const std::string chosen = common.dds;
  Findings findings;
  common.server.clear();
  common.timeout = std::min(common.timeout, kMostPatience);
  const std::string subject = "server by " + chosen;
  try {
    client::Client client(bus_options(common));
    findings.push_back({Level::kOk, "DDS library", client.bus_version(), ""});
    if (!client.wait_for_server(common.timeout)) {
      const bool seen = !client.servers().empty();
      findings.push_back({Level::kWarn, subject,
                          seen ? "a server is seen, but does not answer" : "no server on domain " + std::to_string(common.domain),
                          seen ? "look at its log" : "start footholdd, or give its --domain"});
      return findings;
    }
    for (const client::ServerSeen& server : client.servers()) findings.push_back(judge(subject, server));
  } catch (const transport::BusError& error) {
    findings.push_back({Level::kFail, "DDS library", error.what(), "without it only the other vendor can be used"});
  }
  return findings;
}

}  // namespace

Findings check_servers(const Common& common) {
  Findings findings;
  for (const char* vendor : {"cyclone", "fastdds"}) {
    Common with = common;
    with.dds = vendor;
    // A vendor's configuration file means nothing to the other vendor.
    if (!common.network.empty() && common.dds != vendor) continue;
    for (Finding& finding : check_vendor(with)) findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace foothold::cli
