// How the journal meets SQLite's errors. For the journal's own sources only.
#pragma once

#include "journal/journal.hpp"

namespace foothold::server {

// A failed write gives up the whole transaction, and its caller knows.
template <class Work>
auto SqliteJournal::writing(Work&& work) -> decltype(work()) {
  const auto give_up = [&] {
    rows_.clear();  // rows that were not committed may be given to others
    open_ = false;
    lost_.reset();
    if (!database_.in_transaction()) return;
    try {
      database_.run("ROLLBACK");
    } catch (const sqlite::Error&) {
      // SQLite has rolled back by itself after some errors, and says so by this one.
    }
  };
  try {
    if (lost_) throw JournalError(*lost_);
    if (!open_) sql_.begin.run();
    open_ = true;
    return work();
  } catch (const sqlite::Error& error) {
    give_up();
    throw JournalError(error.what());
  } catch (const JournalError&) {
    give_up();
    throw;
  }
}

// A failed read leaves the transaction as it is, unless SQLite gave it up: then the next write or commit() fails too.
template <class Work>
auto SqliteJournal::reading(Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const sqlite::Error& error) {
    if (open_ && !database_.in_transaction()) lost_ = error.what();
    throw JournalError(error.what());
  }
}

}  // namespace foothold::server
