// The plan of a bundle, and the batches of a journal's log: entries, and what they tell of requests.
#include "../fuzzing.hpp"
#include "jobs/ports.hpp"
#include "journal/view.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  server::EntryView view;
  std::size_t bodies = 0;
  try {
    server::visit_entries(fuzz::octets_of(data, size), [&](const server::Entry& entry) {
      bodies += entry.body.size();
      view.add(entry);
      fuzz::demand(view.find(entry.request) != nullptr, "what was told is known");
    });
  } catch (const server::JournalError&) {
  }
  fuzz::demand(bodies <= size, "entries lie within their batch");
  return 0;
}
