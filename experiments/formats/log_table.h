// SPDX-License-Identifier: GPL-3.0-or-later
// Records of an event log as rows of a table: aligned for people, or as CSV (RFC 4180).
//
// Ids in one field are separated by single spaces; an id that has a space, a quotation mark or a
// backslash is written as a JSON string. Edges that came or went are the ids of their ends, two each.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_TABLE_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_TABLE_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/formats/log_filter.h"
#include "experiments/formats/log_reader.h"
#include "experiments/formats/log_uses.h"

namespace kinex::formats {

// One record, in the columns of kPlain; empty where the log has nothing.
using LogRow = std::vector<std::string>;
LogRow log_row(const LogRecord& record, const LogHeader& header);
// The rows as lines without line breaks, with every column as wide as its longest field; columns that are
// empty everywhere are left out. The column at `numbers` (seq) is flush right.
std::vector<std::string> aligned_rows(const std::vector<LogRow>& rows, std::size_t numbers = 0);

enum class LogTableForm {
  kPlain,  // seq time exactly structure kind ids effect certificate
  kCsv,    // seq,time,polynomial,root,lower,upper,structure,kind,ids,external,predicate,
           // certificate_ids,gone,came,reason
};

struct LogTable {
  std::string text;
  std::uint64_t shown = 0, records = 0;
  ExternalByUse external;  // of all records
  bool complete = true;  // false: the log was cut off
};

// `columns`: names of columns of the form, in the order wanted; none: all. `reader` has read nothing but
// the header. Throws InputError as LogReader does, and for a column that the form does not have.
LogTable log_table(LogReader& reader, const LogFilter& filter, LogTableForm form,
                   const std::vector<std::string>& columns = {});

// The name of an instant, as a fraction, or as a root: "1/3", "root 2 of 4 - 6 t + t^2". A long one is
// abridged: "a fraction of 40 digits", "root 2 of a polynomial of degree 4". Empty if the log has none.
std::string instant_words(const LogInstant& instant, const LogHeader& header);

}  // namespace kinex::formats

#endif
