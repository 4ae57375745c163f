// SPDX-License-Identifier: GPL-3.0-or-later
// Finished cells and studies as text, and back: what a record of them holds.
#ifndef KINEX_EXPERIMENTS_LAB_CELL_RECORD_H
#define KINEX_EXPERIMENTS_LAB_CELL_RECORD_H

#include <optional>

#include "experiments/lab/field_archive.h"
#include "experiments/lab/judge.h"

namespace kinex::lab {

// Its runs, contest and seconds. Checks are recomputed from the runs.
Fields cell_fields(const CellResult& result);
// nullopt if the texts are not of a cell. `cell`: what was run.
std::optional<CellResult> cell_of(const Fields& fields, const Cell& cell);

Fields study_fields(const StudyResult& result);
std::optional<StudyResult> study_of(const Fields& fields);

}  // namespace kinex::lab

#endif
