// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/sqlite.h"

#include <sqlite3.h>

#include <stdexcept>

namespace kinex {

namespace {

[[noreturn]] void fail(sqlite3* handle) {
  throw std::runtime_error(std::string("SQLite: ") + sqlite3_errmsg(handle));
}

}  // namespace

void Database::Close::operator()(sqlite3* handle) const { sqlite3_close(handle); }

Database::Database() {
  sqlite3* handle = nullptr;
  const int code = sqlite3_open(":memory:", &handle);
  handle_.reset(handle);
  if (code != SQLITE_OK) fail(handle);
}

void Database::execute(const char* sql) {
  if (sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail(handle_.get());
}

std::string Database::serialise() {
  sqlite3_int64 size = 0;
  unsigned char* bytes = sqlite3_serialize(handle_.get(), "main", &size, 0);
  if (bytes == nullptr) throw std::bad_alloc();
  std::string text(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  sqlite3_free(bytes);
  return text;
}

std::int64_t Database::last_row() const { return sqlite3_last_insert_rowid(handle_.get()); }

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(Database& database, const char* sql) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database.raw(), sql, -1, &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) fail(database.raw());
}

void Statement::bound(int code) {
  if (code != SQLITE_OK) fail(database_.raw());
  ++next_;
}

Statement& Statement::text(std::string_view value) {
  bound(sqlite3_bind_text64(statement_.get(), next_, value.data(), value.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8));
  return *this;
}

Statement& Statement::integer(std::int64_t value) {
  bound(sqlite3_bind_int64(statement_.get(), next_, value));
  return *this;
}

Statement& Statement::real(double value) {
  bound(sqlite3_bind_double(statement_.get(), next_, value));
  return *this;
}

Statement& Statement::null() {
  bound(sqlite3_bind_null(statement_.get(), next_));
  return *this;
}

std::int64_t Statement::run() {
  if (sqlite3_step(statement_.get()) != SQLITE_DONE) fail(database_.raw());
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
  next_ = 1;
  return database_.last_row();
}

}  // namespace kinex
