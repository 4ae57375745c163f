// SPDX-License-Identifier: GPL-3.0-or-later
// LogEnding: whether an event log holds all of its run, and how far it goes.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_ENDING_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_ENDING_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/numbers/rational.h"
#include "experiments/formats/log_reader.h"

namespace kinex::formats {

struct LogEnding {
  std::string status = "cut off";   // or as the last line says: done, limit, interrupted
  std::optional<Rational> reached;  // nullopt: no end, or cut off
  std::size_t cut_line = 0;         // the line within which it was cut off; 0: none
  std::vector<LogCorruption> corrupt;  // structures without records from some time on

  bool whole() const { return status == "done"; }
};

// Of a log that has been read to its end.
LogEnding ending_of(const LogReader& reader);
// "ends at t = 0.25: limit", "was cut off", "was cut off within line 14"; empty for a whole log.
std::string ending_text(const LogEnding& ending);
// The same for a message, with a remedy; empty for a whole log.
std::string ending_note(const LogEnding& ending, const std::string& file);
// A line for each corrupt structure: "LABEL is corrupt: TEXT; it has no records from then on".
std::vector<std::string> corruption_texts(const std::vector<LogCorruption>& corrupt);

}  // namespace kinex::formats

#endif
