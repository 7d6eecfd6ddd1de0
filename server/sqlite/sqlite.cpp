// SQLite with owners and exceptions.
#include "sqlite/sqlite.hpp"

#include <sqlite3.h>

namespace foothold::sqlite {
namespace {

[[noreturn]] void fail(sqlite3* database, const std::string& what) {
  const char* file = sqlite3_db_filename(database, "main");
  throw Error(std::string(file != nullptr ? file : "") + ": " + what + ": " + sqlite3_errmsg(database),
              sqlite3_errcode(database) & 0xFF);
}

void check_bound(sqlite3_stmt* statement, int result) {
  if (result != SQLITE_OK) fail(sqlite3_db_handle(statement), sqlite3_sql(statement));
}

}  // namespace

bool Error::is_full() const noexcept { return code_ == SQLITE_FULL; }

void Statement::Close::operator()(sqlite3_stmt* statement) const noexcept { sqlite3_finalize(statement); }

Statement& Statement::bind(int parameter, std::int64_t value) {
  check_bound(statement_.get(), sqlite3_bind_int64(statement_.get(), parameter, value));
  return *this;
}

Statement& Statement::bind(int parameter, std::span<const std::byte> value) {
  // An empty span may have no address, which SQLite would take for NULL.
  const void* address = value.empty() ? "" : static_cast<const void*>(value.data());
  check_bound(statement_.get(), sqlite3_bind_blob64(statement_.get(), parameter, address, value.size(), SQLITE_STATIC));
  return *this;
}

Statement& Statement::bind(int parameter, std::span<const std::uint8_t> value) { return bind(parameter, std::as_bytes(value)); }

Statement& Statement::bind(int parameter, std::string_view value) {
  const char* address = value.empty() ? "" : value.data();
  check_bound(statement_.get(),
              sqlite3_bind_text64(statement_.get(), parameter, address, value.size(), SQLITE_STATIC, SQLITE_UTF8));
  return *this;
}

bool Statement::step() {
  const int result = sqlite3_step(statement_.get());
  if (result == SQLITE_ROW) return true;
  if (result != SQLITE_DONE) fail(sqlite3_db_handle(statement_.get()), sqlite3_sql(statement_.get()));
  return false;
}

void Statement::run() {
  const Reset reset(*this);
  step();
}

void Statement::reset() noexcept { sqlite3_reset(statement_.get()); }

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

std::span<const std::byte> Statement::bytes(int column) const {
  const auto* address = static_cast<const std::byte*>(sqlite3_column_blob(statement_.get(), column));
  return {address, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

std::string Statement::text(int column) const {
  const auto* address = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return address == nullptr ? std::string()
                            : std::string(address, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)));
}

bool Statement::is_null(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL; }

void Database::Close::operator()(sqlite3* database) const noexcept { sqlite3_close_v2(database); }

Database::Database(const std::string& path, Access access) : path_(path) {
  sqlite3* database = nullptr;
  const int how = access == Access::kRead ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  const int result = sqlite3_open_v2(path.c_str(), &database, how | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(database);
  if (result != SQLITE_OK)
    throw Error(path + ": cannot be opened: " + (database != nullptr ? sqlite3_errmsg(database) : "out of memory"), result & 0xFF);
  sqlite3_busy_timeout(database, 5000);
}

void Database::run(const std::string& sql) {
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail(database_.get(), sql);
}

Statement Database::prepare(const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v3(database_.get(), sql.c_str(), -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr) != SQLITE_OK)
    fail(database_.get(), sql);
  Statement prepared;
  prepared.statement_.reset(statement);
  return prepared;
}

std::int64_t Database::integer(const std::string& sql) {
  Statement statement = prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

std::string Database::text(const std::string& sql) {
  Statement statement = prepare(sql);
  return statement.step() ? statement.text(0) : std::string();
}

std::int64_t Database::last_row() const { return sqlite3_last_insert_rowid(database_.get()); }
bool Database::in_transaction() const { return sqlite3_get_autocommit(database_.get()) == 0; }

}  // namespace foothold::sqlite
