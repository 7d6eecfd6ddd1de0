// The journal in SQLite: accepted requests, their steps and final states, and the server's id. Survives kill -9 at any moment with
// everything that was committed.
//
// One transaction for each commit(). Write-ahead log, synchronous=NORMAL: a commit reaches the operating system, so it survives the
// end of this process; after a power failure the last moments may be missing, never the consistency. No fsync on the loop: the log
// is carried over into the database by a thread of its own (checkpoints.hpp).
//
// Requests have integer row numbers. Steps lie in the order of their arrival, so that steps of many plans fill few pages; a small
// index leads from (request, number) to them.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "jobs/ports.hpp"
#include "journal/checkpoints.hpp"
#include "sqlite/sqlite.hpp"

namespace foothold::server {

class SqliteJournal final : public Journal {
 public:
  // Opens or creates `path`. Throws JournalError: not a journal of foothold, of another schema version, damaged, not writable; the
  // message says what to do.
  explicit SqliteJournal(const std::string& path);

  // Made when the journal was, the same for ever.
  const Id& server_id() const { return server_id_; }

  void add_request(const msg::PlanRequest& request, Stamp received) override;
  void add_step(const Id& request, std::uint32_t index, const Bytes& step) override;
  void set_scene(const Id& request, const std::vector<msg::Shape>& shapes) override;
  void set_final(const Id& request, const msg::PlanEvent& event) override;
  void commit() override;
  bool knows(const Id& request) override;
  std::optional<Record> find(const Id& request) override;
  std::vector<Bytes> steps(const Id& request, std::uint32_t from) override;
  std::vector<Record> unfinished() override;
  bool forget_before(Stamp stamp) override;

  static constexpr int kSchemaVersion = 1;

 private:
  using Row = std::int64_t;
  struct Statements {
    sqlite::Statement begin, commit, add_request, add_unfinished, add_step, set_scene, end_unfinished, add_ending;
    sqlite::Statement row_of, request, ending, scene, last_step, steps, unfinished;
    sqlite::Statement old, forget_steps, forget_scene, forget_ending, forget_request;
  };

  void open();
  void create();
  void check_file();
  void prepare();
  void keep_log_short(int pages);
  std::optional<Row> row_of(const Id& request);
  Row row_for_writing(const Id& request);
  Record record(Row row);
  // guarded.hpp: both turn SQLite's errors into JournalErrors.
  template <class Work>
  auto writing(Work&& work) -> decltype(work());
  template <class Work>
  auto reading(Work&& work) -> decltype(work());

  sqlite::Database database_;
  Statements sql_;
  Id server_id_{};
  std::unordered_map<Id, Row, msg::IdHash> rows_;  // of unfinished requests
  Bytes buffer_;
  bool open_ = false;                // a transaction
  std::optional<std::string> lost_;  // why the open transaction is no more, if nobody was told yet
  std::optional<Checkpoints> checkpoints_;
};

}  // namespace foothold::server
