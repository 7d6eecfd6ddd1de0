// The journal's log as a crash or a loss of power may leave it: its batches and the entries in them.
#include "../fuzzing.hpp"
#include "journal/entry.hpp"
#include "journal/log.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  std::size_t bodies = 0;
  server::visit_batches(fuzz::octets_of(data, size), [&](std::span<const std::byte> batch) {
    server::visit_entries(batch, [&](const server::Entry& entry) { bodies += entry.body.size(); });
  });
  fuzz::demand(bodies <= size, "entries lie within their batch");
  return 0;
}
