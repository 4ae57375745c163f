// SPDX-License-Identifier: GPL-3.0-or-later
// ResultDatabase: a SQLite database of results in memory, written row by row: SQLiteCpp, and what it
// lacks.
#ifndef KINEX_EXPERIMENTS_LAB_RESULT_DATABASE_H
#define KINEX_EXPERIMENTS_LAB_RESULT_DATABASE_H

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "experiments/lab/machine.h"

namespace kinex::lab {

// The tables of the databases that the program writes: experiments/schemas/*.sql, with its comments.
std::string_view verify_schema();
std::string_view trade_schema();
std::string_view sweep_schema();

// Every failure throws SQLite::Exception, a std::runtime_error with SQLite's message. For a database
// in memory a failure is a bug, or memory is exhausted.
class ResultDatabase {
 public:
  explicit ResultDatabase(std::string_view schema);

  // Inserts a row, a value for each column: texts as TEXT, whole numbers and truth values as
  // INTEGER, doubles as REAL; nullptr, and an optional value that is absent, as NULL. Returns its
  // rowid, which is the value of an INTEGER PRIMARY KEY that was NULL.
  template <class... Values>
  std::int64_t insert(const char* table, const Values&... values) {
    SQLite::Statement& statement = insertion(table, sizeof...(values));
    int place = 0;
    (bind(statement, ++place, values), ...);
    return run(statement);
  }
  // The rows of the tables `build` and `machine`, one each (id 1).
  void insert_facts(const BuildFacts& build, const MachineFacts& machine);

  // The bytes of a database file. To be called once, at the end.
  std::string bytes();

 private:
  template <class Value>
  static void bind(SQLite::Statement& statement, int place, const Value& value) {
    if constexpr (std::is_same_v<Value, std::nullptr_t>) {
      statement.bind(place);
    } else if constexpr (std::is_integral_v<Value>) {
      statement.bind(place, static_cast<std::int64_t>(value));
    } else if constexpr (std::is_floating_point_v<Value>) {
      statement.bind(place, value);
    } else {
      statement.bind(place, std::string(value));
    }
  }
  template <class Value>
  static void bind(SQLite::Statement& statement, int place, const std::optional<Value>& value) {
    value ? bind(statement, place, *value) : bind(statement, place, nullptr);
  }
  SQLite::Statement& insertion(const char* table, std::size_t columns);
  std::int64_t run(SQLite::Statement& statement);

  SQLite::Database database_{":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
  std::map<std::string, SQLite::Statement, std::less<>> insertions_;  // by table
};

}  // namespace kinex::lab

#endif
