// SPDX-License-Identifier: GPL-3.0-or-later
// Which record of one event log is which of another: by what it says, and by its instant.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_MATCH_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_MATCH_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "core/numbers/real_root.h"
#include "experiments/formats/log_ending.h"
#include "experiments/formats/log_reader.h"

namespace kinex::formats {

// How the instants of two records were compared.
enum class InstantsCompared {
  kExactly,    // both logs name them: compared as numbers, whatever their names
  kIntervals,  // both have at least intervals: the same unless these are disjoint
  kNot,        // one log has none, or is of an inexact arithmetic
};

// A log as far as records are matched.
struct MatchedLog {
  struct Entry {
    std::uint32_t name = 0;     // of all that must agree; one numbering for both logs
    std::uint32_t instant = 0;  // place in `instants`
  };
  LogHeader header;
  LogEnding ending;
  std::vector<Entry> entries;        // in the order of the log
  std::vector<LogInstant> instants;  // distinct ones, in the order of the log
};

// Compares instants of two logs, each pair once.
class InstantsOf {
 public:
  InstantsOf(const MatchedLog& a, const MatchedLog& b);

  InstantsCompared compared() const { return compared_; }
  // True also where they are not compared.
  bool same(std::uint32_t in_a, std::uint32_t in_b);

 private:
  bool look(const LogInstant& a, const LogInstant& b);

  const MatchedLog& a_;
  const MatchedLog& b_;
  InstantsCompared compared_ = InstantsCompared::kNot;
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> known_;
  RootCounters counters_;
};

struct LogMatch {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  // For each entry of a the place in b of its match, or kNone; each entry of b is matched once at most.
  std::vector<std::size_t> in_b;
  // Entries without a match that the other log says nothing about, since it ends before them.
  std::vector<bool> after_b, after_a;  // of a, of b
};

// Matches entries of one name: those at the same instant, and of those left over as many as can be
// between these, next to each other in time; k-th with k-th where both logs have equally many. Where the
// instants are not compared decimals tell what is near, and without them the order in the logs. `names`: how
// many there are.
LogMatch match_logs(const MatchedLog& a, const MatchedLog& b, InstantsOf& instants,
                    std::size_t names);

}  // namespace kinex::formats

#endif
