// SPDX-License-Identifier: GPL-3.0-or-later
// CellSource: where an experiment has the records of its cells from: its journal; else each cell is run
// now, in a child process, so that a crash of one is a result of it and not the end of the others.
#ifndef KINEX_EXPERIMENTS_SWEEP_CELL_SOURCE_H
#define KINEX_EXPERIMENTS_SWEEP_CELL_SOURCE_H

#include <functional>
#include <optional>
#include <string>

#include "experiments/sweep/journal.h"
#include "experiments/sweep/plan_cell.h"

namespace kinex::sweep {

struct CellSource {
  Journal* journal = nullptr;  // its cells are not run again; new records are added to it
  // Children are started as PROGRAM sweep cell TEXT; empty: cells are run in this process.
  std::string program;
  std::function<bool()> go_on = [] { return true; };  // called from all threads

  // Whether record_of would run the cell.
  bool is_to_be_run(const PlanCell& cell) const;
  // The record of the cell, as it is in the journal. nullopt: go_on() returned false; nothing is then
  // recorded. `here` runs the cell in this process (nullopt: interrupted), if it is not run in a child:
  // an exception of it is recorded as a crash. May be called from several threads: then several
  // children run at a time.
  std::optional<Record> record_of(const PlanCell& cell,
                                  const std::function<std::optional<CellReport>()>& here) const;
};

}  // namespace kinex::sweep

#endif
