// SPDX-License-Identifier: GPL-3.0-or-later
// What the attempts of a sweep say together, cell by cell.
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

// By key, the record that stands for the cell: a verdict before anything else, then in the order of
// Outcome from the last result to the first (crash, memory, limit), then killed. Among equals the
// one that comes first. The attempts must outlive it.
using Settled = std::map<std::string_view, const Record*>;
void take(Settled& settled, const Record& record);
Settled settle(const std::vector<Attempt>& attempts);

// True if the cell need not be run again under these limits: it has a verdict, it crashed, or it
// reached limits that are no lower. `retry`: only a verdict counts.
bool is_settled(const Record& record, const Limits& limits, bool retry);

// The plans of the attempts, each once, by name and hash.
std::vector<Plan> plans_of(const std::vector<Attempt>& attempts);

// Counts of cells by outcome, and those without an attempt.
struct Tally {
  std::array<std::size_t, kOutcomeNames.size()> counts{};  // in the order of kOutcomeNames
  std::size_t missing = 0;
  std::size_t of(Outcome outcome) const { return counts[static_cast<std::size_t>(outcome)]; }
  std::size_t cells() const;
  // "12 done, 1 limit, 3 missing"; kinds without cells are left out.
  std::string text() const;
};
Tally tally(const std::vector<PlannedCell>& cells, const Settled& settled);

// Expected CPU seconds of the cells that are missing or were killed: their expected costs, scaled
// by what cells of the same structure and arithmetic took (of any, where there are none). nullopt
// if no cell is done yet.
std::optional<double> expected_rest(const std::vector<PlannedCell>& cells, const Settled& settled);

}  // namespace kinex::sweep

#endif
