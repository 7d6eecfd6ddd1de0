// The journal's log as a crash or a loss of power may leave it: its batches, and the entries in them.
#include "../fuzzing.hpp"
#include "jobs/ports.hpp"
#include "journal/entry.hpp"
#include "journal/log.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  const auto octets = fuzz::octets_of(data, size);
  std::size_t bodies = 0;
  const auto visit = [&](const server::Entry& entry) { bodies += entry.body.size(); };
  server::visit_entries(octets, visit);
  fuzz::demand(bodies <= size, "entries lie within their batch");
  const std::string segment = fuzz::as_file("journal-log.1", octets);
  try {
    server::Log(segment.substr(0, segment.size() - 2)).replay([&](std::span<const std::byte> batch) {
      server::visit_entries(batch, visit);
    });
  } catch (const server::JournalError&) {
  }
  return 0;
}
