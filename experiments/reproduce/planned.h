// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment "reproduce" of plans: the points and studies of a paper's parts as cells of a plan,
// their results as records, and back.
#ifndef KINEX_EXPERIMENTS_REPRODUCE_PLANNED_H
#define KINEX_EXPERIMENTS_REPRODUCE_PLANNED_H

#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/checked_by.h"
#include "experiments/lab/part.h"
#include "experiments/sweep/experiment.h"
#include "experiments/sweep/record.h"

namespace kinex::reproduce {

// Throws InputError with the names that there are.
const lab::Paper& paper_named(const std::string& name);
// All parts for no names.
std::vector<const lab::PaperPart*> parts_named(const lab::Paper& paper,
                                               const std::vector<std::string>& names);

// {"series": {..}}: everything that decides the runs. Parts of papers may share a point.
sweep::PlanCell planned(const lab::SeriesPoint& point);
// {"paper_study": {"part": .., "quick": ..}}
sweep::PlanCell planned_study(const lab::PaperPart& part, bool quick);
// {"checked": {"program": .., "run": ..}}: the second program's verdict on a small run. Checks are
// in journals and in no plan: they take seconds, and no other machine needs to have that program.
sweep::PlanCell planned_check(const lab::RunKey& run, std::string_view program);

// kFailed where an audit or a bound of a run failed.
sweep::CellReport report_of(const lab::SeriesResult& result);
sweep::CellReport report_of(const lab::StudyResult& result);
sweep::CellReport report_of(const lab::CheckedBy& checked);

// What the record holds. `trouble` becomes the reason where it holds no result (a crash, a limit).
lab::SeriesResult series_of(const sweep::Record& record, const lab::SeriesPoint& point,
                            std::string& trouble);
lab::StudyResult study_of(const sweep::Record& record, std::string& trouble);
lab::CheckedBy check_of(const sweep::Record& record, const lab::RunKey& run);

// The selection of `kinex reproduce PAPER PART.. --quick`.
sweep::Selection selection_of(const std::string& paper, const std::vector<std::string>& parts,
                              bool quick);
// Adds the experiment, and its kinds of cells.
void add_experiment(sweep::Experiments& experiments);

}  // namespace kinex::reproduce

#endif
