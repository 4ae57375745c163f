// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment "trade" of plans: its cases and bits as cells of a plan, their results as records,
// and back.
#ifndef KINEX_EXPERIMENTS_TRADE_PLANNED_H
#define KINEX_EXPERIMENTS_TRADE_PLANNED_H

#include <optional>
#include <string>
#include <vector>

#include "experiments/sweep/experiment.h"
#include "experiments/sweep/record.h"
#include "experiments/trade/runner.h"

namespace kinex::trade {

// {"trade": {..}}, {"bits": {..}}: everything that decides the runs. A scene that was given is in
// it by its hash: such a cell is of no plan, and no other process can run it.
sweep::PlanCell planned(const TradeCase& which, const TradeOptions& options);
sweep::PlanCell planned(const BitsCase& which, const TradeOptions& options);

// kFailed for faults; kLimit where a run gave up.
sweep::CellReport report_of(const CaseResult& result);
sweep::CellReport report_of(const std::optional<BitsResult>& result);  // nullopt: kLimit

// Where the record has no result, the problem says why.
CaseResult result_of(const sweep::Record& record, const TradeCase& which);
BitsResult result_of(const sweep::Record& record, const BitsCase& which);

// The selection of `kinex trade WHAT .. --quick --arithmetic ..`.
sweep::Selection selection_of(const std::vector<std::string>& what, bool quick,
                              const TradeOptions& options);
// Adds the experiment, and its two kinds of cells.
void add_experiment(sweep::Experiments& experiments);

}  // namespace kinex::trade

#endif
