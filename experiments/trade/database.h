// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as a SQLite database with the tables of schemas/trade.sql.
//
// Exact values and ratios are TEXT, counts INTEGER, and REAL is for seconds only (of the clock, and of
// errors of event times; infinite for a time that is no number).
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
