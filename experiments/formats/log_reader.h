// SPDX-License-Identifier: GPL-3.0-or-later
// LogReader: reads an event log (see event_log.h) line by line.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_READER_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_READER_H

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/numbers/instant_name.h"
#include "core/numbers/polynomial.h"
#include "core/numbers/rational.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/provenance.h"

namespace kinex::formats {

struct LogStructure {
  std::string label;
  std::string structure;
  std::string key;  // JSON, as key_json() writes it; empty: none
  std::vector<std::string> kinds;
  // Canonical JSON of what it reads and of its parameters, as in "maintain"; empty: the usual.
  std::string options = {};
};

struct LogHeader {
  std::string scene, scene_hash, arithmetic, build;
  bool exact = true;
  InstantDetail instants = InstantDetail::kName;
  std::vector<LogStructure> structures;
  std::vector<std::string> objects;
  std::optional<Provenance> provenance;  // if it was asked for

  bool has_names() const { return exact && instants == InstantDetail::kName; }
  bool has_intervals() const { return exact && instants != InstantDetail::kNone; }
  bool has_times() const { return instants != InstantDetail::kNone; }
};

struct LogInstant {
  Polynomial polynomial;  // if the header has_names(), as the next
  int root = 0;
  Rational lower, upper;  // if it has_intervals()
  std::string decimal;    // if it has_times()
};

// "gone" and "came" of a record: tuples (flattened) or whole values of the attribute.
struct LogChange {
  std::size_t width = 0;  // of the tuples; 0: ids
  std::vector<std::string> gone, came;
};

struct LogCertificate {
  std::string predicate;
  std::vector<std::string> ids;
};

struct LogRecord {
  std::size_t line = 0;   // in the file, from 1
  std::string_view text;  // the line itself
  std::uint64_t sequence = 0;
  std::string structure;  // label
  std::string kind;
  std::vector<std::string> ids;
  std::optional<LogCertificate> certificate;
  bool external = false;
  std::optional<std::string> reason;
  std::optional<LogChange> change;
  LogInstant time;
};

// A structure that an inexact arithmetic led into an impossible state, and what the run found.
struct LogCorruption {
  std::string label, text;
  bool operator==(const LogCorruption&) const = default;
};

struct LogEnd {
  std::string status;
  std::optional<Rational> reached;
  std::uint64_t records = 0;
  std::uint64_t external = 0;
  std::vector<LogCorruption> corrupt;
  std::string digest;
  std::string seal;
  std::string_view sealed;  // the text that the seal covers
};

// True if the text begins like an event log (and not like a scene).
bool looks_like_log(std::string_view text);

class LogReader {
 public:
  // Reads the header. `text` must outlive the reader. Throws InputError, as next() does, for a line
  // that is not of the form given in event_log.h, and for another version. The contents of lines
  // are not verified (log_check.h does that).
  LogReader(std::string_view text, std::string file);

  const std::string& file() const { return file_; }
  const LogHeader& header() const { return header_; }
  // The next record; false at the end of the log, and at a line within which it was cut off.
  bool next(LogRecord& record);
  // The last line, once next() has returned false; nullopt: the log was cut off.
  const std::optional<LogEnd>& end() const { return end_; }
  // Then also: the number of the line within which it was cut off; 0: it ends with a whole line.
  std::size_t cut_line() const { return cut_line_; }
  std::size_t line() const { return line_; }

 private:
  bool next_line(std::string_view& line);
  // nullopt: the log was cut off within this line, its last one.
  std::optional<JsonDocument> parse_line(std::string_view line) const;
  void read_header(std::string_view line);

  std::string_view text_, rest_;
  std::string file_;
  std::size_t line_ = 0, cut_line_ = 0;
  LogHeader header_;
  std::optional<LogEnd> end_;
};

}  // namespace kinex::formats

#endif
