// Checkpoints of the journal's log.
#include "journal/checkpoints.hpp"

#include <sqlite3.h>

#include "sqlite/sqlite.hpp"

namespace foothold::server {

Checkpoints::Checkpoints(std::string path) : path_(std::move(path)), thread_([this] { work(); }) {}

Checkpoints::~Checkpoints() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Checkpoints::start() {
  if (busy_.exchange(true)) return;
  {
    const std::lock_guard lock(mutex_);
    due_ = true;
  }
  wake_.notify_one();
}

void Checkpoints::work() {
  try {
    const sqlite::Database database(path_);
    std::unique_lock lock(mutex_);
    for (;;) {
      wake_.wait(lock, [&] { return due_ || stopping_; });
      if (stopping_) return;
      due_ = false;
      lock.unlock();
      // Passive: never in the way of the loop. A failure (disk full) only means that the log stays long; the next one tries again.
      sqlite3_wal_checkpoint_v2(database.handle(), nullptr, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
      busy_ = false;
      lock.lock();
    }
  } catch (const sqlite::Error&) {
    busy_ = true;
    // It stays busy for ever, and the loop makes the checkpoints itself when the log is far too long (journal.cpp).
  }
}

}  // namespace foothold::server
