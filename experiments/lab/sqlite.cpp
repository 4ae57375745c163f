// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/sqlite.h"

#include <sqlite3.h>

#include <new>

namespace kinex::lab {

std::string Database::serialise() {
  sqlite3_int64 size = 0;
  unsigned char* bytes = sqlite3_serialize(database_.getHandle(), "main", &size, 0);
  if (bytes == nullptr) throw std::bad_alloc();
  std::string text(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  sqlite3_free(bytes);
  return text;
}

Statement& Statement::null() {
  statement_.bind(next_++);
  return *this;
}

std::int64_t Statement::run() {
  statement_.exec();
  statement_.reset();
  statement_.clearBindings();
  next_ = 1;
  return database_.getLastInsertRowid();
}

}  // namespace kinex::lab
