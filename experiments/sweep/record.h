// SPDX-License-Identifier: GPL-3.0-or-later
// Record: one attempt at one cell, as a line of an attempt file.
#ifndef KINEX_EXPERIMENTS_SWEEP_RECORD_H
#define KINEX_EXPERIMENTS_SWEEP_RECORD_H

#include <cstddef>
#include <string>
#include <string_view>

#include "experiments/formats/json_document.h"
#include "experiments/lab/child_process.h"
#include "experiments/sweep/cell_run.h"
#include "experiments/sweep/outcome.h"
#include "experiments/sweep/plan.h"

namespace kinex::sweep {

struct Record {
  std::string key;   // of the cell
  std::string cell;  // cell_text
  Outcome outcome = Outcome::kDone;
  int signal = 0;       // the signal that ended the child; 0: it exited
  int code = 0;         // its exit code
  std::string message;  // the failure: the last line of an error message
  Limits limits;        // the limits of this attempt
  std::string exact;    // CellReport::exact
  // Not exact:
  std::string times;      // CellReport::times
  double simulate_s = 0;  // CPU time of the simulation alone
  double cpu_s = 0;       // CPU time of the child
  double wall_s = 0;
  long peak_kb = 0;   // 0: unknown
  std::string ended;  // UTC
};

// The record of a child that ran `cell` with these limits and has ended.
Record record_of(const PlanCell& cell, const Limits& limits, const lab::ChildProcess& child,
                 const lab::ChildEnd& end);
// Of a cell that was run in this process, without limits.
Record record_of(const PlanCell& cell, const CellReport& report, double wall_s);

// One line, without a line break. parse_record reads it back, and record_line of the result is the
// same text.
std::string record_line(const Record& record);
// Throws InputError that names the file and the line, also if the key is not that of the cell.
Record parse_record(std::string_view line, const std::string& file, std::size_t number);

// False if the records contradict each other: different verdicts, or different exact fields, on one
// cell.
bool agree(const Record& a, const Record& b);

// Typed access to the members of a line of an attempt file. Throws InputError for a member that is
// missing or of another kind.
class LineFields {
 public:
  LineFields(const formats::JsonValue& value, const std::string& file, std::size_t line)
      : value_(value), file_(file), line_(line) {}
  const formats::JsonValue& member(const char* name) const;
  std::string text(const char* name) const;
  long long whole(const char* name) const;
  double real(const char* name) const;
  bool boolean(const char* name) const;
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  const formats::JsonValue& member(const char* name, formats::JsonValue::Kind kind) const;
  const formats::JsonValue& value_;
  const std::string& file_;
  std::size_t line_;
};

std::string utc_text(const char* format);  // now, by strftime

}  // namespace kinex::sweep

#endif
