// A DDS domain of this process. Cyclone holds one configuration per domain and process, so buses on the same domain share it.
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <string>

#include "foothold/transport/bus.hpp"

namespace foothold::transport::cyclone {

// Any thread. Throws BusError if the domain cannot be made, or if it is in use here: with another configuration, or
// when either is secured.
class Domain {
 public:
  Domain(std::uint32_t id, const std::string& network_config, bool secured);
  ~Domain();
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;
  std::uint32_t id() const { return id_; }

 private:
  std::uint32_t id_;
};

// "<what>: <Cyclone's word for the code>".
BusError error(const std::string& what, dds_return_t code);

}  // namespace foothold::transport::cyclone
