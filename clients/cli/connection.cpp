// Finding the server.
#include "connection.hpp"

#include <algorithm>
#include <chrono>

#include "interrupt.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLook = 0.05;  // s between looks at Ctrl-C

std::string names(const std::vector<client::ServerSeen>& servers) {
  std::string list;
  for (const auto& server : servers)
    if (server.alive) list += (list.empty() ? "" : ", ") + printable(server.info.name());
  return list;
}

// By name or by id.
std::optional<client::ServerSeen> find(const std::vector<client::ServerSeen>& servers, const std::string& wanted) {
  const auto found = std::ranges::find_if(servers, [&](const client::ServerSeen& server) {
    return server.alive && (wanted.empty() || server.info.name() == wanted || msg::to_hex(server.info.key()) == wanted);
  });
  return found == servers.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

msg::Id parse_id(const std::string& text) {
  const auto id = msg::id_from_hex(text);
  if (!id || *id == msg::kNoId)
    throw Complaint(Exit::kUsage, "'" + printable(text) + "' is no request's id", "an id is 32 hexadecimal digits, not all zero");
  return *id;
}

transport::BusOptions bus_options(const Common& common) {
  return {.vendor = common.dds, .domain = common.domain, .network_config = common.network, .security = common.security};
}

Connection connect(const Common& common) {
  Connection connection;
  watch_interrupts();
  try {
    connection.client = std::make_unique<client::Client>(bus_options(common));
  } catch (const transport::BusError& error) {
    throw Complaint(Exit::kOther, error.what(), "'foothold doctor' looks at what DDS needs");
  }
  const auto begin = Clock::now();
  while (true) {
    const double left = common.timeout - std::chrono::duration<double>(Clock::now() - begin).count();
    const bool open = connection.client->wait_for_server(std::clamp(left, 0.0, kLook));
    const auto servers = connection.client->servers();
    if (const auto server = find(servers, common.server); open && server) {
      connection.server = *server;
      if (!common.server.empty()) connection.wanted = server->info.key();
      return connection;
    }
    if (interrupted()) throw Complaint(Exit::kInterrupted, "interrupted before a server answered; nothing was sent");
    if (left > 0.0) continue;
    const std::string where = "with " + common.dds + " on domain " + std::to_string(common.domain);
    if (!names(servers).empty() && !common.server.empty())
      throw Complaint(Exit::kNoServer, "no server '" + common.server + "' " + where, "there are: " + names(servers));
    throw Complaint(Exit::kNoServer, "no server answered within " + duration(common.timeout) + " " + where,
                    "start footholdd, or give its --domain; 'foothold doctor' looks for what is in the way");
  }
}

std::string describe(const Connection& connection, const Common& common) {
  return format("%s %s (%s, domain %u)", printable(connection.server.info.name()).c_str(),
                printable(connection.server.info.version()).c_str(), connection.client->bus_version().c_str(), common.domain);
}

}  // namespace foothold::cli
