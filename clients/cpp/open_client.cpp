// A client on a vendor's bus. Apart from client.cpp, so that who brings a bus of his own needs no vendor.
#include "foothold/client/client.hpp"
#include "foothold/security/credentials.hpp"

namespace foothold::client {
namespace {

// With credentials a client's id, and so its partition, is one that they allow.
ClientOptions permitted(const transport::BusOptions& bus, ClientOptions options) {
  if (bus.security.empty()) return options;
  try {
    const security::Credentials credentials =
        security::read_credentials(bus.security, bus.vendor, security::Role::kClient, "a client");
    if (options.id == msg::kNoId) options.id = security::client_id(credentials);
    if (!security::is_id_of(credentials, options.id))
      throw transport::BusError("id: with the credentials of " + credentials.name + " a client's id begins with " +
                                security::partition_prefix(credentials) + ", not as " + msg::to_hex(options.id));
  } catch (const security::SecurityError& error) {
    throw transport::BusError(std::string("security: ") + error.what());
  }
  return options;
}

}  // namespace

Client::Client(const transport::BusOptions& bus, ClientOptions options)
    : Client(transport::open_bus(bus), permitted(bus, options)) {}

}  // namespace foothold::client
