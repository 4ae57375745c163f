// SPDX-License-Identifier: GPL-3.0-or-later
// A database in memory, and statements on it whose values are bound from left to right: SQLiteCpp,
// and the two things that it lacks.
#ifndef KINEX_EXPERIMENTS_LAB_SQLITE_H
#define KINEX_EXPERIMENTS_LAB_SQLITE_H

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kinex::lab {

// Every failure throws SQLite::Exception, a std::runtime_error with SQLite's message. For a database
// in memory a failure is a bug, or memory is exhausted.
class Database {
 public:
  void execute(const char* sql) { database_.exec(sql); }
  // The bytes of a database file.
  std::string serialise();

 private:
  friend class Statement;
  SQLite::Database database_{":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
};

// insert.text("a").integer(1).run()
class Statement {
 public:
  Statement(Database& database, const char* sql)
      : database_(database.database_), statement_(database_, sql) {}
  Statement& text(std::string_view value) { return bind(std::string(value)); }
  Statement& integer(std::int64_t value) { return bind(value); }
  Statement& count(std::uint64_t value) { return integer(static_cast<std::int64_t>(value)); }
  Statement& real(double value) { return bind(value); }
  Statement& null();
  Statement& maybe(const std::optional<std::int64_t>& value) {
    return value ? integer(*value) : null();
  }
  // Executes it and clears the values. Returns the row that was inserted.
  std::int64_t run();

 private:
  template <class Value>
  Statement& bind(const Value& value) {
    statement_.bind(next_++, value);
    return *this;
  }

  SQLite::Database& database_;
  SQLite::Statement statement_;
  int next_ = 1;
};

}  // namespace kinex::lab

#endif
