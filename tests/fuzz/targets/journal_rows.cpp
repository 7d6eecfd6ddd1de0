// Rows of the journal's database whose contents are not what they should be: entries of any octets, written and read again.
#include "../fuzzing.hpp"
#include "journal/store.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  static const test::TemporaryFolder kFolder;
  static server::Store store(kFolder / "journal.db");
  std::vector<server::Id> ids;
  store.begin();
  server::visit_entries(fuzz::octets_of(data, size), [&](const server::Entry& entry) {
    store.apply(entry);
    ids.push_back(entry.request);
  });
  for (const server::Id& id : ids) {
    try {
      const auto record = store.find(id);
      store.steps(id, 0);
      if (record) fuzz::demand(store.knows(id), "what is found is known");
    } catch (const server::JournalError&) {
    }
  }
  try {
    store.unfinished();
  } catch (const server::JournalError&) {
  }
  store.roll_back();
  return 0;
}
