// config/footholdd.yaml.
#include "../fuzzing.hpp"
#include "config/reading.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  try {
    const server::ServerConfig config = server::read_server_config(fuzz::as_file("footholdd.yaml", fuzz::octets_of(data, size)));
    fuzz::demand(config.dds.domain <= 200, "the domain is one");
    fuzz::demand(config.grace >= 0.0 && config.retention >= 0.0, "times are not negative");
  } catch (const server::ConfigError& error) {
    fuzz::demand(!error.faults().empty(), "a refusal says why");
  }
  return 0;
}
