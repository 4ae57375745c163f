// SPDX-License-Identifier: GPL-3.0-or-later
// LogReader: reads an event log (see event_log.h) line by line.
#ifndef KINEX_EXPERIMENTS_LOG_READER_H
#define KINEX_EXPERIMENTS_LOG_READER_H

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/polynomial.h"
#include "core/rational.h"

namespace kinex {

struct LogStructure {
  std::string label;
  std::string structure;
  std::vector<std::string> kinds;
};

struct LogHeader {
  std::string scene, scene_hash, arithmetic, build;
  bool exact = true;
  std::vector<LogStructure> structures;
};

struct LogInstant {
  Polynomial polynomial;  // exact logs only, as the next three
  int root = 0;
  Rational lower, upper;
  std::string decimal;
};

struct LogEvent {
  std::size_t line = 0;   // in the file, from 1
  std::string_view text;  // the line itself
  std::uint64_t sequence = 0;
  std::string structure;  // label
  std::string kind;
  std::vector<std::string> ids;
  std::string predicate;  // empty: a change of the scene
  bool external = false;
  LogInstant time;
};

struct LogEnd {
  std::string status;
  std::uint64_t events = 0;
  std::string digest;
};

// True if the text begins like an event log (and not like a scene).
bool looks_like_log(std::string_view text);

class LogReader {
 public:
  // Reads the header. `text` must outlive the reader. Throws InputError, as next() does, for a line
  // that is not of the form that event_log.h gives; what the line claims is not checked here.
  LogReader(std::string_view text, std::string file);

  const std::string& file() const { return file_; }
  const LogHeader& header() const { return header_; }
  // The next event; false at the end of the log.
  bool next(LogEvent& event);
  // The last line, once next() has returned false; nullopt: the log was cut off.
  const std::optional<LogEnd>& end() const { return end_; }
  std::size_t line() const { return line_; }

 private:
  bool next_line(std::string_view& line);
  void read_header(std::string_view line);

  std::string_view rest_;
  std::string file_;
  std::size_t line_ = 0;
  LogHeader header_;
  std::optional<LogEnd> end_;
};

}  // namespace kinex

#endif
