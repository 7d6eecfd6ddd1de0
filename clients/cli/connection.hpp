// The way from the options that every command has to a client that has found its server.
#pragma once

#include <optional>
#include <string>

#include "commands.hpp"
#include "foothold/client/client.hpp"

namespace foothold::cli {

struct Connection {
  std::unique_ptr<client::Client> client;
  client::ServerSeen server;  // the one that was asked for, or any
  msg::Id wanted{};           // its id if one was asked for, else zeros
};

transport::BusOptions bus_options(const Common& common);

// Waits for a server, --timeout at most. Throws Complaint: no vendor library, bad --server, no server (kNoServer), Ctrl-C.
Connection connect(const Common& common);

// A request's id as 32 hexadecimal digits. Throws Complaint.
msg::Id parse_id(const std::string& text);

// "yard-1 (cyclone 0.10.2, domain 0)"
std::string describe(const Connection& connection, const Common& common);

}  // namespace foothold::cli
