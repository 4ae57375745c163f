// SPDX-License-Identifier: GPL-3.0-or-later
// A database in memory, and prepared statements on it.
#ifndef KINEX_EXPERIMENTS_LAB_SQLITE_H
#define KINEX_EXPERIMENTS_LAB_SQLITE_H

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace kinex {

// Every failure throws std::runtime_error with SQLite's message: with a database in memory it is a
// bug, or memory is exhausted.
class Database {
 public:
  Database();
  void execute(const char* sql);
  // The bytes of a database file.
  std::string serialise();
  std::int64_t last_row() const;
  sqlite3* raw() { return handle_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

// Values are bound from left to right: insert.text("a").integer(1).run().
class Statement {
 public:
  Statement(Database& database, const char* sql);
  Statement& text(std::string_view value);
  Statement& integer(std::int64_t value);
  Statement& count(std::uint64_t value) { return integer(static_cast<std::int64_t>(value)); }
  Statement& real(double value);
  Statement& null();
  Statement& maybe(const std::optional<std::int64_t>& value) {
    return value ? integer(*value) : null();
  }
  // Executes it and clears the values. Returns the row that was inserted.
  std::int64_t run();

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  void bound(int code);

  Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int next_ = 1;
};

}  // namespace kinex

#endif
