// The journal's database: opening and writing.
#include "journal/store.hpp"

#include <sqlite3.h>

#include <cstring>

namespace foothold::server {
namespace {

constexpr std::int64_t kApplication = 0x666F6F74;  // "foot", in the file's header
constexpr std::int64_t kCheckedPages = 16384;      // larger files are not read as a whole at start

constexpr const char* kSchema = R"(
  PRAGMA application_id = 0x666F6F74;
  CREATE TABLE server (key TEXT PRIMARY KEY, value BLOB NOT NULL) WITHOUT ROWID;
  CREATE TABLE request (row INTEGER PRIMARY KEY, id BLOB NOT NULL UNIQUE, received INTEGER NOT NULL, body BLOB NOT NULL);
  CREATE TABLE unfinished (row INTEGER PRIMARY KEY);
  CREATE TABLE ending (row INTEGER PRIMARY KEY, stamp INTEGER NOT NULL, event BLOB NOT NULL);
  CREATE TABLE scene (row INTEGER PRIMARY KEY, event BLOB NOT NULL);
  CREATE TABLE step (request INTEGER NOT NULL, number INTEGER NOT NULL, body BLOB NOT NULL, UNIQUE (request, number));
)";

std::string damaged(const std::string& path, const std::string& found) {
  return path + ": is damaged (" + found + "); move it away, with its -wal and -shm, to start with an empty journal";
}

}  // namespace

Store::Store(const std::string& path) try : database_(path) {
  // Checkpoints wait for the disk: who writes says when (checkpoint()).
  database_.run(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 0; PRAGMA temp_store = MEMORY;");
  if (database_.integer("SELECT count(*) FROM sqlite_schema") == 0) create();
  check_file();
  prepare();
  sqlite::Statement id = database_.prepare("SELECT value FROM server WHERE key = 'id'");
  if (!id.step() || id.bytes(0).size() != server_id_.size()) throw JournalError(damaged(path, "no server id"));
  std::memcpy(server_id_.data(), id.bytes(0).data(), server_id_.size());
  const auto log_grew = [](void* self, sqlite3*, const char*, int pages) {
    static_cast<Store*>(self)->log_pages_ = pages;
    return SQLITE_OK;
  };
  sqlite3_wal_hook(database_.handle(), log_grew, this);
} catch (const sqlite::Error& error) {
  if (error.code() == SQLITE_NOTADB)
    throw JournalError(path + ": is not a journal of foothold; move it away or choose another state_dir");
  if (error.code() == SQLITE_CORRUPT) throw JournalError(damaged(path, error.what()));
  throw JournalError(error.what());
}

void Store::create() {
  database_.run("BEGIN IMMEDIATE");
  database_.run(kSchema);
  database_.run("PRAGMA user_version = " + std::to_string(kSchemaVersion));
  sqlite::Statement id = database_.prepare("INSERT INTO server VALUES ('id', ?)");
  const Id made = msg::random_id();
  id.bind(1, std::span<const std::uint8_t>(made)).run();
  database_.run("COMMIT");
}

void Store::check_file() {
  const std::string& path = database_.path();
  if (database_.integer("PRAGMA application_id") != kApplication)
    throw JournalError(path + ": is a database, but not a journal of foothold; move it away or choose another state_dir");
  const std::int64_t version = database_.integer("PRAGMA user_version");
  if (version != kSchemaVersion)
    throw JournalError(path + ": has schema version " + std::to_string(version) + ", this server reads version " +
                       std::to_string(kSchemaVersion) + "; move it away or use the server that wrote it");
  if (database_.integer("PRAGMA page_count") > kCheckedPages) return;
  const std::string found = database_.text("PRAGMA quick_check(1)");
  if (found != "ok") throw JournalError(damaged(path, found));
}

void Store::prepare() {
  const auto make = [&](const char* sql) { return database_.prepare(sql); };
  sql_.begin = make("BEGIN IMMEDIATE");
  sql_.commit = make("COMMIT");
  sql_.add_request = make("INSERT OR IGNORE INTO request (id, received, body) VALUES (?, ?, ?)");
  sql_.add_unfinished = make("INSERT INTO unfinished VALUES (?)");
  sql_.add_step = make("INSERT OR IGNORE INTO step VALUES (?, ?, ?)");
  sql_.set_scene = make("INSERT OR REPLACE INTO scene VALUES (?, ?)");
  sql_.end_unfinished = make("DELETE FROM unfinished WHERE row = ?");
  sql_.add_ending = make("INSERT OR IGNORE INTO ending VALUES (?, ?, ?)");
  sql_.row_of = make("SELECT row FROM request WHERE id = ?");
  sql_.request = make("SELECT received, body FROM request WHERE row = ?");
  sql_.ending = make("SELECT event FROM ending WHERE row = ?");
  sql_.scene = make("SELECT event FROM scene WHERE row = ?");
  sql_.last_step = make("SELECT max(number) FROM step WHERE request = ?");
  sql_.steps = make("SELECT body FROM step WHERE request = ? AND number >= ? ORDER BY number LIMIT ?");
  sql_.unfinished = make("SELECT row FROM unfinished ORDER BY row");
  sql_.ids = make("SELECT id FROM request");
  // In the order of receipt, which is the order of the ends but for a budget.
  sql_.old = make("SELECT row, stamp FROM ending ORDER BY row LIMIT ?");
  sql_.forget_steps = make("DELETE FROM step WHERE request = ?");
  sql_.forget_scene = make("DELETE FROM scene WHERE row = ?");
  sql_.forget_ending = make("DELETE FROM ending WHERE row = ?");
  sql_.forget_request = make("DELETE FROM request WHERE row = ?");
}

void Store::begin() { sql_.begin.run(); }
void Store::commit() { sql_.commit.run(); }

void Store::roll_back() noexcept {
  rows_.clear();  // rows that were not committed may be given to others
  if (!database_.in_transaction()) return;
  try {
    database_.run("ROLLBACK");
  } catch (const sqlite::Error&) {
    // SQLite has rolled back by itself after some errors, and says so by this one.
  }
}

void Store::apply(const Entry& entry) {
  const auto id = std::span<const std::uint8_t>(entry.request);
  if (entry.kind == Entry::Kind::kRequest) {
    if (row_of(entry.request)) return;
    sql_.add_request.bind(1, id).bind(2, entry.number).bind(3, entry.body).run();
    const Row row = database_.last_row();
    sql_.add_unfinished.bind(1, row).run();
    rows_[entry.request] = row;
    return;
  }
  const auto row = row_of(entry.request);
  if (!row) return;  // forgotten since
  switch (entry.kind) {
    case Entry::Kind::kStep:
      sql_.add_step.bind(1, *row).bind(2, entry.number).bind(3, entry.body).run();
      break;
    case Entry::Kind::kScene:
      sql_.set_scene.bind(1, *row).bind(2, entry.body).run();
      break;
    default:
      sql_.add_ending.bind(1, *row).bind(2, entry.number).bind(3, entry.body).run();
      sql_.end_unfinished.bind(1, *row).run();
      rows_.erase(entry.request);
  }
}

void Store::checkpoint() {
  constexpr int kLongLog = 1000;  // pages: 4 MB
  if (log_pages_ < kLongLog) return;
  log_pages_ = 0;
  // Passive: readers are never waited for. If it fails (disk full), the next one tries again.
  sqlite3_wal_checkpoint_v2(database_.handle(), nullptr, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
}

bool Store::forget_before(Stamp stamp) {
  constexpr std::int64_t kAtOnce = 50;
  std::vector<Row> rows;
  {
    const sqlite::Reset reset(sql_.old);
    sql_.old.bind(1, kAtOnce);
    while (sql_.old.step())
      if (sql_.old.integer(1) < stamp) rows.push_back(sql_.old.integer(0));
  }
  if (rows.empty()) return false;
  begin();
  for (const Row row : rows) {
    sql_.forget_steps.bind(1, row).run();
    sql_.forget_scene.bind(1, row).run();
    sql_.forget_ending.bind(1, row).run();
    sql_.forget_request.bind(1, row).run();
  }
  commit();
  return rows.size() == static_cast<std::size_t>(kAtOnce);
}

}  // namespace foothold::server
