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
  // Adds "kind=swap,tie,object=a": KEY= and values with commas between them. An id may have commas: what
  // stands behind a KEY= is one value until fit() has seen the log.
  // Throws InputError that names the option for text that is no condition.
  void add(std::string_view text);
  // Takes values that the log does not have apart at their commas. Throws InputError for a kind, structure
  // or object that the log cannot have, and for a predicate that is none of kinex and of no certificate in the log, which
  // is read to its end to know that. `reader` is at the first record.
  void fit(const LogReader& reader);
  bool wants(const LogRecord& record) const;
  bool wants_all() const { return conditions_.empty(); }

 private:
  struct Condition {
    std::string key;
    std::vector<std::string> values;
  };
  std::vector<std::string>* values_of(std::string_view key);

  std::vector<Condition> conditions_;
};

}  // namespace kinex::formats

#endif
