// SPDX-License-Identifier: GPL-3.0-or-later
// `kinex verify` as a plan of the sweep: its cells and studies as cells of a plan, their results as
// records, and back.
#ifndef KINEX_EXPERIMENTS_VERIFY_PLANNED_H
#define KINEX_EXPERIMENTS_VERIFY_PLANNED_H

#include <optional>
#include <string>

#include "experiments/lab/cell.h"
#include "experiments/lab/judge.h"
#include "experiments/sweep/experiment.h"
#include "experiments/sweep/record.h"

namespace kinex::verify {

// {"verify": {..}}: everything that decides the runs; "seeds" as in VerifyOptions.
sweep::PlanCell planned(const lab::Cell& cell, const std::optional<int>& seeds);
// {"study": {"name": .., "quick": ..}}
sweep::PlanCell planned(const lab::Study& study);

// kFailed if a bound or an audit of a run failed; its other expectations do not matter here. kLimit if a run
// took longer than its cell allows.
sweep::CellReport report_of(const lab::CellResult& result);
sweep::CellReport report_of(const lab::StudyResult& result);

// The runs of the record, not yet judged; if it has none, a check that states this. `cell`: the cell
// that was run.
lab::CellResult result_of(const sweep::Record& record, const lab::Cell& cell);
lab::StudyResult study_of(const sweep::Record& record, const lab::Study& study);

// The selection of `kinex verify STRUCTURE --quick --seeds N`.
sweep::Selection selection_of(const std::string& structure, bool quick,
                              const std::optional<int>& seeds);
// Adds the experiment, and its two kinds of cells.
void add_experiment(sweep::Experiments& experiments);

}  // namespace kinex::verify

#endif
