// SPDX-License-Identifier: GPL-3.0-or-later
// The merge of a sweep: the records of all attempts, reduced to one per cell.
//
//   attempt files                                settled
//   shard-0-09:00-..   A done     D killed       A done         a verdict stands
//   shard-1-09:00-..   B limit    C crash        B done         .. before every other outcome
//   shard-0-10:30-..   B done     D limit        C crash        no verdict: the last in the order
//                                                D limit        killed, limit, memory, crash
//                                                E missing      in the plan, without a record
//
// Two verdicts on one cell must agree (record.h): otherwise there is a Conflict and no merge.
#ifndef KINEX_EXPERIMENTS_SWEEP_SETTLED_H
#define KINEX_EXPERIMENTS_SWEEP_SETTLED_H

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/sweep/attempt_file.h"

namespace kinex::sweep {

struct Conflict {
  std::string place_a, line_a;  // "out/shard-0-...jsonl, line 7"
  std::string place_b, line_b;
};

// The first two attempts at one cell, in the order of the files, that do not agree (record.h). An
// attempt without a verdict agrees with everything.
std::optional<Conflict> find_conflict(const std::vector<Attempt>& attempts);

// By key, the record that stands for the cell: a verdict before all others, then crash, memory,
// limit and killed, in this order. Of equal outcomes the first record stands. The attempts must
// outlive it.
using Settled = std::map<std::string_view, const Record*>;
// Replaces the cell's record by this one if it comes before it in that order.
void take(Settled& settled, const Record& record);
Settled settle(const std::vector<Attempt>& attempts);

// True if the cell need not be run again under these limits: it has a verdict, it crashed, or it
// reached limits that are no lower. `retry`: only a verdict counts.
bool is_settled(const Record& record, const Limits& limits, bool retry);

// The plans of the attempts, each once, by name and hash.
std::vector<Plan> plans_of(const std::vector<Attempt>& attempts,
                           const Experiments& experiments = {});

// The number of cells by outcome, and of those without a record.
struct Tally {
  std::array<std::size_t, kOutcomeNames.size()> counts{};  // in the order of kOutcomeNames
  std::size_t missing = 0;
  std::size_t at_max_events = 0;  // of those that are done: ended by the plan's max_events
  std::size_t of(Outcome outcome) const { return counts[static_cast<std::size_t>(outcome)]; }
  std::size_t cells() const;
  // "12 done (2 of them ended at max_events), 1 limit, 3 missing"; kinds without cells are left out.
  std::string text() const;
};
Tally tally(const std::vector<PlanCell>& cells, const Settled& settled);

// Expected CPU seconds of the cells that are missing or were killed: their expected costs, scaled
// by the times of finished cells of the same kind (or of all, if there are none). nullopt if no cell
// is done yet.
std::optional<double> expected_rest(const std::vector<PlanCell>& cells, const Settled& settled);

}  // namespace kinex::sweep

#endif
