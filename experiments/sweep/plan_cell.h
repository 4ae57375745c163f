// SPDX-License-Identifier: GPL-3.0-or-later
// PlanCell: a unit of work of a plan, of whatever kind: a run (run_cell.h), or one of an experiment
// (experiment.h). What decides its exact results is its text.
#ifndef KINEX_EXPERIMENTS_SWEEP_PLAN_CELL_H
#define KINEX_EXPERIMENTS_SWEEP_PLAN_CELL_H

#include <cstdint>
#include <string>

namespace kinex::sweep {

struct PlanCell {
  std::string kind;        // cells of one kind and cost take about as long
  std::string text;        // canonical JSON
  std::string key;         // its SHA-256: the same on every machine
  std::uint64_t cost = 0;  // grows with the time that it takes
};

// `json` in canonical form, with its key.
PlanCell make_cell(std::string kind, const std::string& json, std::uint64_t cost);

}  // namespace kinex::sweep

#endif
