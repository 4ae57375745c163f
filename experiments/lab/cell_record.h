// SPDX-License-Identifier: GPL-3.0-or-later
// The state that an interrupted `kinex verify` resumes from: finished cells and studies as text,
// and back.
#ifndef KINEX_EXPERIMENTS_LAB_CELL_RECORD_H
#define KINEX_EXPERIMENTS_LAB_CELL_RECORD_H

#include <optional>
#include <string>

#include "experiments/lab/judge.h"

namespace kinex {

// Identifies a cell by everything but the program that decides its results; `seeds` as in
// VerifyOptions.
std::string cell_key(const Cell& cell, const std::optional<int>& seeds);
// Its runs, contest and seconds. Checks are recomputed from the runs.
std::string cell_record(const CellResult& result);
// nullopt if the text is no such record. `cell`: the one of the key.
std::optional<CellResult> read_cell_record(const std::string& record, const Cell& cell);

std::string study_key(const Study& study);
std::string study_record(const StudyResult& result);
std::optional<StudyResult> read_study_record(const std::string& record);

}  // namespace kinex

#endif
