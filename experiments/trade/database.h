// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as a SQLite database.
//
// STRICT tables, foreign keys: exact values and ratios are TEXT, counts INTEGER, and REAL is for
// seconds only (of the clock, and of errors of event times; infinite for a time that is no number).
//   build, machine   what made the results: one row each
//   trade_case       one scene with one structure: events, bits needed to separate its instants
//   trade_run        the scene in one arithmetic, compared with the exact run
//   bits             bits needed by the scenes of one family and size
//   bits_growth      bits needed over log2(n): fitted slopes
#ifndef KINEX_EXPERIMENTS_TRADE_DATABASE_H
#define KINEX_EXPERIMENTS_TRADE_DATABASE_H

#include <string>

#include "experiments/lab/machine.h"
#include "experiments/trade/runner.h"

namespace kinex::trade {

// The bytes of the database file.
std::string trade_database(const TradeResult& result, const lab::BuildFacts& build,
                           const lab::MachineFacts& machine);

}  // namespace kinex::trade

#endif
