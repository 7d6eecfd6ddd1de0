// What everything that reads the journal's database shares.
#pragma once

#include "jobs/ports.hpp"
#include "sqlite/sqlite.hpp"

namespace foothold::server {

// Runs a read of the database and turns its errors into the journal's.
template <class Work>
auto reading(Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const sqlite::Error& error) {
    throw JournalError(error.what());
  }
}

}  // namespace foothold::server
