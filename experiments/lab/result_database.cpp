// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/result_database.h"

#include <sqlite3.h>

#include <new>

namespace kinex::lab {

ResultDatabase::ResultDatabase(std::string_view schema) {
  database_.exec("PRAGMA foreign_keys = ON");
  database_.exec(std::string(schema));
  database_.exec("BEGIN");
}

SQLite::Statement& ResultDatabase::insertion(const char* table, std::size_t columns) {
  const auto known = insertions_.find(std::string_view(table));
  if (known != insertions_.end()) return known->second;
  std::string sql = std::string("INSERT INTO ") + table + " VALUES(";
  for (std::size_t i = 0; i < columns; ++i) sql += i == 0 ? "?" : ", ?";
  return insertions_.try_emplace(table, database_, sql + ")").first->second;
}

std::int64_t ResultDatabase::run(SQLite::Statement& statement) {
  statement.exec();
  statement.reset();
  statement.clearBindings();
  return database_.getLastInsertRowid();
}

void ResultDatabase::insert_facts(const BuildFacts& build, const MachineFacts& machine) {
  insert("build", 1, build.program, build.commit, build.dirty, build.compiler, build.flags,
         build.libraries);
  insert("machine", 1, machine.cpu, machine.cores, machine.memory_kb, machine.kernel);
}

std::string ResultDatabase::bytes() {
  insertions_.clear();
  database_.exec("COMMIT");
  sqlite3_int64 size = 0;
  unsigned char* bytes = sqlite3_serialize(database_.getHandle(), "main", &size, 0);
  if (bytes == nullptr) throw std::bad_alloc();
  std::string text(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  sqlite3_free(bytes);
  return text;
}

}  // namespace kinex::lab
