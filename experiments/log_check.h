// SPDX-License-Identifier: GPL-3.0-or-later
// Re-verifies an event log from what it says, without the scene and without a simulator.
#ifndef KINEX_EXPERIMENTS_LOG_CHECK_H
#define KINEX_EXPERIMENTS_LOG_CHECK_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/log_reader.h"

namespace kinex {

struct LogVerdict {
  LogHeader header;
  std::uint64_t events = 0;
  std::uint64_t external = 0;
  std::uint64_t instants = 0;  // distinct (exact logs only)
  std::string status;          // of the last line; empty if there is none
  std::string digest;          // recomputed
  // "line 7: ..." for each claim that does not hold; at most kMaxProblems are kept.
  static constexpr std::size_t kMaxProblems = 20;
  std::vector<std::string> problems;
};

// Checks that sequence numbers count up, that structures and kinds are those of the header, that
// the last line has the number of events and the digest; in an exact log also that each polynomial
// is primitive, square-free and has a positive leading coefficient, that the interval holds exactly
// the root of that index (Sturm's theorem), and that times never decrease (exactly). Throws
// InputError for text that is no event log, or is cut off in the middle of a line.
LogVerdict check_log(std::string_view text, const std::string& file);

}  // namespace kinex

#endif
