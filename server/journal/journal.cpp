// The journal in SQLite: opening, writing, committing.
#include "journal/journal.hpp"

#include <sqlite3.h>

#include <cstring>

#include "journal/guarded.hpp"

namespace foothold::server {
namespace {

constexpr std::int64_t kApplication = 0x666F6F74;  // "foot", in the file's header
// Pages of the log, 4 kB each: when to carry it over, when to begin it anew, and when to do that at any price.
constexpr int kCheckpointLog = 1000;
constexpr int kLongLog = 32768;
constexpr int kFarTooLongLog = 131072;
constexpr std::int64_t kCheckedPages = 16384;  // larger files are not read as a whole at start

constexpr const char* kSchema = R"(
  PRAGMA application_id = 0x666F6F74;
  CREATE TABLE server (key TEXT PRIMARY KEY, value BLOB NOT NULL) WITHOUT ROWID;
  CREATE TABLE request (row INTEGER PRIMARY KEY, id BLOB NOT NULL UNIQUE, received INTEGER NOT NULL, body BLOB NOT NULL);
  CREATE TABLE unfinished (row INTEGER PRIMARY KEY);
  CREATE TABLE ending (row INTEGER PRIMARY KEY, stamp INTEGER NOT NULL, event BLOB NOT NULL);
  CREATE TABLE scene (row INTEGER PRIMARY KEY, event BLOB NOT NULL);
  CREATE TABLE step (request INTEGER NOT NULL, number INTEGER NOT NULL, body BLOB NOT NULL, UNIQUE (request, number));
)";

}  // namespace

SqliteJournal::SqliteJournal(const std::string& path) try : database_(path) { open(); } catch (const sqlite::Error& error) {
  if (error.code() == SQLITE_NOTADB)
    throw JournalError(path + ": is not a journal of foothold; move it away or choose another state_dir");
  if (error.code() == SQLITE_CORRUPT)
    throw JournalError(path + ": is damaged (" + error.what() +
                       "); move it away, with -wal and -shm, to start with an empty journal");
  throw JournalError(error.what());
}

void SqliteJournal::open() {
  database_.run(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 0; PRAGMA temp_store = MEMORY;");
  if (database_.integer("SELECT count(*) FROM sqlite_schema") == 0) create();
  check_file();
  prepare();
  sqlite::Statement id = database_.prepare("SELECT value FROM server WHERE key = 'id'");
  if (!id.step() || id.bytes(0).size() != server_id_.size())
    throw JournalError(database_.path() + ": has no server id; move it away");
  std::memcpy(server_id_.data(), id.bytes(0).data(), server_id_.size());
  checkpoints_.emplace(database_.path());
  const auto log_grew = [](void* self, sqlite3*, const char*, int pages) {
    static_cast<SqliteJournal*>(self)->keep_log_short(pages);
    return SQLITE_OK;
  };
  sqlite3_wal_hook(database_.handle(), log_grew, this);
}

// Under load the thread never catches up with the last page, so the log would grow for ever. It is begun anew from here, just after
// the thread has done its part: then little is left to do while the loop waits for the disk.
void SqliteJournal::keep_log_short(int pages) {
  const bool rested = !checkpoints_->busy();
  if ((pages > kLongLog && rested) || pages > kFarTooLongLog)
    sqlite3_wal_checkpoint_v2(database_.handle(), nullptr, SQLITE_CHECKPOINT_RESTART, nullptr, nullptr);
  else if (pages > kCheckpointLog)
    checkpoints_->start();
}

void SqliteJournal::create() {
  database_.run("BEGIN IMMEDIATE");
  database_.run(kSchema);
  database_.run("PRAGMA user_version = " + std::to_string(kSchemaVersion));
  sqlite::Statement id = database_.prepare("INSERT INTO server VALUES ('id', ?)");
  const Id made = msg::random_id();
  id.bind(1, std::span<const std::uint8_t>(made)).run();
  database_.run("COMMIT");
}

void SqliteJournal::check_file() {
  const std::string& path = database_.path();
  if (database_.integer("PRAGMA application_id") != kApplication)
    throw JournalError(path + ": is a database, but not a journal of foothold; move it away or choose another state_dir");
  const std::int64_t version = database_.integer("PRAGMA user_version");
  if (version != kSchemaVersion)
    throw JournalError(path + ": has schema version " + std::to_string(version) + ", this server reads version " +
                       std::to_string(kSchemaVersion) + "; move it away or use the server that wrote it");
  if (database_.integer("PRAGMA page_count") > kCheckedPages) return;
  const std::string found = database_.text("PRAGMA quick_check(1)");
  if (found != "ok")
    throw JournalError(path + ": is damaged (" + found + "); move it away, with -wal and -shm, to start with an empty journal");
}

void SqliteJournal::prepare() {
  const auto make = [&](const char* sql) { return database_.prepare(sql); };
  sql_.begin = make("BEGIN IMMEDIATE");
  sql_.commit = make("COMMIT");
  sql_.add_request = make("INSERT INTO request (id, received, body) VALUES (?, ?, ?)");
  sql_.add_unfinished = make("INSERT INTO unfinished VALUES (?)");
  sql_.add_step = make("INSERT INTO step VALUES (?, ?, ?)");
  sql_.set_scene = make("INSERT OR REPLACE INTO scene VALUES (?, ?)");
  sql_.end_unfinished = make("DELETE FROM unfinished WHERE row = ?");
  sql_.add_ending = make("INSERT INTO ending VALUES (?, ?, ?)");
  sql_.row_of = make("SELECT row FROM request WHERE id = ?");
  sql_.request = make("SELECT received, body FROM request WHERE row = ?");
  sql_.ending = make("SELECT event FROM ending WHERE row = ?");
  sql_.scene = make("SELECT event FROM scene WHERE row = ?");
  sql_.last_step = make("SELECT max(number) FROM step WHERE request = ?");
  sql_.steps = make("SELECT body FROM step WHERE request = ? AND number >= ? ORDER BY number");
  sql_.unfinished = make("SELECT row FROM unfinished ORDER BY row");
  // In the order of receipt, which is the order of the ends but for a budget.
  sql_.old = make("SELECT row, stamp FROM ending ORDER BY row LIMIT ?");
  sql_.forget_steps = make("DELETE FROM step WHERE request = ?");
  sql_.forget_scene = make("DELETE FROM scene WHERE row = ?");
  sql_.forget_ending = make("DELETE FROM ending WHERE row = ?");
  sql_.forget_request = make("DELETE FROM request WHERE row = ?");
}

void SqliteJournal::add_request(const msg::PlanRequest& request, Stamp received) {
  writing([&] {
    msg::encode_into(request, buffer_);
    sql_.add_request.bind(1, std::span<const std::uint8_t>(request.id()))
        .bind(2, received)
        .bind(3, std::span<const std::byte>(buffer_));
    sql_.add_request.run();
    const Row row = database_.last_row();
    sql_.add_unfinished.bind(1, row).run();
    rows_[request.id()] = row;
  });
}

void SqliteJournal::add_step(const Id& request, std::uint32_t index, const Bytes& step) {
  writing([&] {
    sql_.add_step.bind(1, row_for_writing(request)).bind(2, std::int64_t{index}).bind(3, std::span<const std::byte>(step)).run();
  });
}

// Kept as an event that carries nothing but the shapes: a message has a form of its own on disk, a sequence has not.
void SqliteJournal::set_scene(const Id& request, const std::vector<msg::Shape>& shapes) {
  writing([&] {
    msg::PlanEvent event;
    event.scene(shapes);
    msg::encode_into(event, buffer_);
    sql_.set_scene.bind(1, row_for_writing(request)).bind(2, std::span<const std::byte>(buffer_)).run();
  });
}

void SqliteJournal::set_final(const Id& request, const msg::PlanEvent& event) {
  writing([&] {
    const Row row = row_for_writing(request);
    msg::encode_into(event, buffer_);
    sql_.add_ending.bind(1, row).bind(2, event.stamp()).bind(3, std::span<const std::byte>(buffer_)).run();
    sql_.end_unfinished.bind(1, row).run();
    rows_.erase(request);
  });
}

void SqliteJournal::commit() {
  if (!open_) return;
  writing([&] { sql_.commit.run(); });
  open_ = false;
}

SqliteJournal::Row SqliteJournal::row_for_writing(const Id& request) {
  const auto row = row_of(request);
  if (!row) throw JournalError("request " + msg::to_hex(request) + " is not in the journal");
  return *row;
}

bool SqliteJournal::forget_before(Stamp stamp) {
  constexpr std::int64_t kAtOnce = 50;
  return writing([&] {
    std::vector<Row> rows;
    {
      const sqlite::Reset reset(sql_.old);
      sql_.old.bind(1, kAtOnce);
      while (sql_.old.step())
        if (sql_.old.integer(1) < stamp) rows.push_back(sql_.old.integer(0));
    }
    for (const Row row : rows) {
      sql_.forget_steps.bind(1, row).run();
      sql_.forget_scene.bind(1, row).run();
      sql_.forget_ending.bind(1, row).run();
      sql_.forget_request.bind(1, row).run();
    }
    return rows.size() == static_cast<std::size_t>(kAtOnce);
  });
}

}  // namespace foothold::server
