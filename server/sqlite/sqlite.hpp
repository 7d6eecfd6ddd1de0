// SQLite with owners and exceptions: a database and its prepared statements. Knows nothing of what is stored.
//
// Thread rule: one thread at a time for a database and its statements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace foothold::sqlite {

// what(): the file, what was being done, and SQLite's own words.
class Error : public std::runtime_error {
 public:
  Error(const std::string& message, int code) : std::runtime_error(message), code_(code) {}
  int code() const noexcept { return code_; }  // SQLite's primary result code
  bool is_full() const noexcept;               // the disk or a quota is full

 private:
  int code_;
};

// Parameters are numbered from 1, columns from 0, as in SQLite. Bound bytes and text must live until the next reset().
class Statement {
 public:
  Statement() = default;
  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, std::span<const std::byte> value);
  Statement& bind(int parameter, std::span<const std::uint8_t> value);
  Statement& bind(int parameter, std::string_view value);
  // True if there is a row. Throws Error.
  bool step();
  // For statements without rows: step and reset. Throws Error; reset all the same.
  void run();
  void reset() noexcept;

  std::int64_t integer(int column) const;
  std::span<const std::byte> bytes(int column) const;  // until the next step() or reset()
  std::string text(int column) const;
  bool is_null(int column) const;

 private:
  friend class Database;
  struct Close {
    void operator()(sqlite3_stmt* statement) const noexcept;
  };
  std::unique_ptr<sqlite3_stmt, Close> statement_;
};

// Resets a statement at the end of a scope, so that no read transaction stays open.
class Reset {
 public:
  explicit Reset(Statement& statement) : statement_(statement) {}
  ~Reset() { statement_.reset(); }
  Reset(const Reset&) = delete;
  Reset& operator=(const Reset&) = delete;

 private:
  Statement& statement_;
};

class Database {
 public:
  enum class Access { kWrite, kRead };
  // Opens, or with kWrite creates. Waits up to 5 s for another process's lock. Throws Error.
  explicit Database(const std::string& path, Access access = Access::kWrite);
  // Several statements separated by ';', rows are not wanted.
  void run(const std::string& sql);
  Statement prepare(const std::string& sql);
  // The first column of the first row.
  std::int64_t integer(const std::string& sql);
  std::string text(const std::string& sql);
  std::int64_t last_row() const;  // rowid of the latest INSERT
  bool in_transaction() const;
  sqlite3* handle() const { return database_.get(); }
  const std::string& path() const { return path_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const noexcept;
  };
  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace foothold::sqlite
