// SPDX-License-Identifier: GPL-3.0-or-later
// LogFilter: which records of an event log are wanted.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_FILTER_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_FILTER_H

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/formats/log_reader.h"

namespace kinex::formats {

// A record is wanted if it has, of every kind of condition that is given, one of the values:
//   kind       its kind
//   structure  its structure's label
//   object     an id of the record, of its certificate, or of what came or went
//   predicate  its certificate's predicate
//   external   true or false
class LogFilter {
 public:
  // Adds "kind=swap,kind=tie,object=a". A comma ends a value where KEY= follows, so ids may have commas.
  // Throws InputError that names the option for text that is no condition.
  void add(std::string_view text);
  // Throws InputError for a kind, structure or object that the log cannot have.
  void check(const LogHeader& header, const std::string& file) const;
  bool wants(const LogRecord& record) const;
  bool wants_all() const { return conditions_.empty(); }

 private:
  struct Condition {
    std::string key;
    std::vector<std::string> values;
  };
  const std::vector<std::string>* values_of(std::string_view key) const;

  std::vector<Condition> conditions_;
};

}  // namespace kinex::formats

#endif
