// The journal's database: requests, steps, scenes and final states in SQLite. Writing the same entry again changes nothing.
//
// Requests have integer row numbers. Steps lie in the order of their arrival, so that steps of many plans fill few pages; a small
// index leads from (request, number) to them.
//
// Thread rule: one thread for a Store; several Stores may be open on the same file, one of them writing.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "jobs/ports.hpp"
#include "journal/entry.hpp"
#include "sqlite/sqlite.hpp"

namespace foothold::server {

class Store {
 public:
  static constexpr int kSchemaVersion = 2;

  // Opens or creates. Throws JournalError: not a journal of foothold, of another schema version, damaged, not writable; the message
  // says what to do.
  explicit Store(const std::string& path);
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  // All below throw sqlite::Error, and JournalError for octets that are no messages.
  const Id& server_id() const { return server_id_; }
  void begin();
  void apply(const Entry& entry);
  void commit();
  void roll_back() noexcept;
  // Carries the write-ahead log over into the database file if it is long. Waits for the disk.
  void checkpoint();
  // Forgets a few requests that ended before `stamp`, in a transaction of its own. False when there are no more.
  bool forget_before(Stamp stamp);

  bool knows(const Id& request);
  std::optional<Record> find(const Id& request);
  std::vector<Bytes> steps(const Id& request, std::uint32_t from, std::uint32_t most = kAllSteps);
  std::vector<Record> unfinished();
  void visit_ids(const std::function<void(const Id&)>& visit);

 private:
  using Row = std::int64_t;
  struct Statements {
    sqlite::Statement begin, commit, add_request, add_unfinished, add_step, set_scene, end_unfinished, add_ending;
    sqlite::Statement row_of, request, ending, scene, last_step, steps, unfinished, ids;
    sqlite::Statement old, forget_steps, forget_scene, forget_ending, forget_request;
  };

  void create();
  void check_file();
  void prepare();
  std::optional<Row> row_of(const Id& request);
  std::optional<Record> record(Row row);

  sqlite::Database database_;
  Statements sql_;
  Id server_id_{};
  int log_pages_ = 0;                              // of SQLite's write-ahead log, after the latest commit
  std::unordered_map<Id, Row, msg::IdHash> rows_;  // of unfinished requests
};

}  // namespace foothold::server
