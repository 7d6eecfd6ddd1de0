// A client on a vendor's bus. Apart from client.cpp, so that who brings a bus of his own needs no vendor.
#include "foothold/client/client.hpp"

namespace foothold::client {

Client::Client(const transport::BusOptions& bus, ClientOptions options) : Client(transport::open_bus(bus), options) {}

}  // namespace foothold::client
