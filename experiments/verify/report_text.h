// SPDX-License-Identifier: GPL-3.0-or-later
// The results as a table for people and as JSON lines for programs.
#ifndef KINEX_EXPERIMENTS_VERIFY_REPORT_TEXT_H
#define KINEX_EXPERIMENTS_VERIFY_REPORT_TEXT_H

#include <string>

#include "experiments/verify/runner.h"

namespace kinex::verify {

// The columns of a cell's row, as text. Means over its scenes where there are several.
struct CellRow {
  std::string structure, workload, n, runs, external, internal;
  std::string bound;     // hard bound on the events; "-" if there is none with known constants
  std::string expected;  // of its first expectation; "-" if it has none
  std::string observed;  // likewise; the events if it has none
  std::string checks;    // "5/5": holding, of all
  std::string verdict;
  std::string ratio;  // CPU time in `exact` over `double`; "-": too short; "differs": other events
};
CellRow cell_row(const lab::CellResult& cell);

// True if some of these cells may have a hard bound on their events.
bool shows_bounds(const std::vector<lab::Cell>& cells);
// `bounds`: with a column of bounds.
std::string table_header(bool bounds = true);
// One line, and one more for each check that is not a PASS, and for each scene kept.
std::string table_row(const lab::CellResult& cell, bool bounds = true);
// One line, and one more for the neighbours of its law.
std::string table_row(const lab::GrowthResult& growth);
// Its checks, a line each.
std::string table_row(const lab::StudyResult& study);
// The remedy if scenes are too few to decide, with a newline; empty if they are not.
std::string seeds_line(const VerifyResult& result);

// {"row": "cell", ..} and {"row": "growth", ..}, with a newline.
std::string json_row(const lab::CellResult& cell);
std::string json_row(const lab::GrowthResult& growth);
std::string json_row(const lab::StudyResult& study);

}  // namespace kinex::verify

#endif
