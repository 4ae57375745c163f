// SPDX-License-Identifier: GPL-3.0-or-later
// Record: one attempt at one cell, as a line of an attempt file.
#ifndef KINEX_EXPERIMENTS_SWEEP_RECORD_H
#define KINEX_EXPERIMENTS_SWEEP_RECORD_H

#include <cstddef>
#include <string>
#include <string_view>

#include "experiments/formats/json_value.h"
#include "experiments/lab/child_process.h"
#include "experiments/sweep/outcome.h"
#include "experiments/sweep/plan.h"

namespace kinex::sweep {

struct Record {
  std::string key;   // of the cell
  std::string cell;  // cell_text
  Outcome outcome = Outcome::kDone;
  int signal = 0;       // that ended the child; 0: it exited
  int code = 0;         // its exit code
  std::string message;  // what failed; the last line of an error message
  Limits limits;        // that it ran with
  std::string exact;    // CellReport::exact
  // Not exact:
  double simulate_s = 0;  // CPU time of the simulation alone
  double cpu_s = 0;       // of the child
  double wall_s = 0;
  long peak_kb = 0;   // 0: unknown
  std::string ended;  // UTC
};

// Of a child that was given `cell` and these limits, and has ended.
Record record_of(const PlannedCell& cell, const Limits& limits, const ChildProcess& child,
                 const ChildEnd& end);

// One line without its line break. parse_record reads it back, and record_line of that is the same
// text.
std::string record_line(const Record& record);
// Throws InputError that names the file and the line, also if the key is not that of the cell.
Record parse_record(std::string_view line, const std::string& file, std::size_t number);

// Can both be right? False if they contain different verdicts, or exact fields, on one cell.
bool agree(const Record& a, const Record& b);

// Strings, whole numbers and fractions of attempt files. The value that is missing or of another
// kind throws InputError.
class LineFields {
 public:
  LineFields(const JsonValue& value, const std::string& file, std::size_t line)
      : value_(value), file_(file), line_(line) {}
  const JsonValue& member(const char* name) const;
  const std::string& text(const char* name) const;
  long long whole(const char* name) const;
  double real(const char* name) const;
  bool boolean(const char* name) const;
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  const JsonValue& member(const char* name, JsonValue::Kind kind) const;
  const JsonValue& value_;
  const std::string& file_;
  std::size_t line_;
};

std::string utc_text(const char* format);  // now, by strftime

}  // namespace kinex::sweep

#endif
