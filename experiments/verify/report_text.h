// SPDX-License-Identifier: GPL-3.0-or-later
// The results as a table for people and as JSON lines for programs, and the verdict on all of them.
#ifndef KINEX_EXPERIMENTS_VERIFY_REPORT_TEXT_H
#define KINEX_EXPERIMENTS_VERIFY_REPORT_TEXT_H

#include <optional>
#include <string>
#include <vector>

#include "experiments/formats/json_writer.h"
#include "experiments/lab/table.h"
#include "experiments/lab/time_taken.h"
#include "experiments/verify/runner.h"

namespace kinex::verify {

// The columns of a cell's row, as text. Means over its scenes where there are several.
struct CellRow {
  std::string structure, workload, n, runs, external, internal;
  std::string bound;     // hard bound on the events; "-" if there is none with known constants
  std::string expected;  // of its first expectation; "-" if it has none
  std::string observed;  // likewise; the events if it has none
  std::string checks;    // "5/5": holding, of all
  std::string ratio;     // CPU time in `exact` over `double`; "-": too short; "differs": other events
  std::string verdict;

  // In the order of cell_columns.
  std::vector<std::string> texts(bool bounds) const;
};
CellRow cell_row(const lab::CellResult& cell);
// CPU time in `exact` over that in `double`; nullopt if it was not measured, or doubles had other events.
std::optional<double> exact_over_double(const lab::CellResult& cell);
// `bounds`: with a column of bounds. The checks are the last but two, the verdict is the last.
std::vector<lab::TextColumn> cell_columns(bool bounds);

// True if some of these cells may have a hard bound on their events.
bool shows_bounds(const std::vector<lab::Cell>& cells);
std::string table_header(bool bounds = true);
// What the columns are, a line for each that its title does not say.
std::string table_legend(bool bounds = true);
// One line, and one more for each check that is not a PASS, and for each scene kept.
std::string table_row(const lab::CellResult& cell, bool bounds = true);
// One line, and one more for the neighbours of its law.
std::string table_row(const lab::GrowthResult& growth);
// Its checks, a line each.
std::string table_row(const lab::StudyResult& study);
// The remedy if scenes are too few to decide, with a newline; empty if they are not.
std::string seeds_line(const VerifyResult& result);
// "716 of 716 hold; 0 fail; 5 min"; "12 of 15 hold; 1 fails; 2 inconclusive; 40 s".
std::string verdict_line(const VerifyResult& result, const lab::TimeTaken& taken);
// What was done: "702 cells and 14 fits: 4312 checks, 9123 runs, 1234567 certificate failures".
std::string work_line(const VerifyResult& result);

// The tables after the cells: laws against their neighbours, those of families and comparisons.
std::vector<lab::Table> more_tables(const VerifyResult& result);

// {"row": "cell", ..}, {"row": "growth", ..} and {"row": "study", ..}, with a newline.
std::string json_row(const lab::CellResult& cell);
std::string json_row(const lab::GrowthResult& growth);
std::string json_row(const lab::StudyResult& study);
// The object of a cell's parameters; `seeds`: with their number.
std::string parameters_json(const lab::CellResult& cell, bool seeds);

}  // namespace kinex::verify

#endif
