// SPDX-License-Identifier: GPL-3.0-or-later
// Experiment: a plan that the program makes itself, by name, from what is selected of it. Its cells
// have texts with one member, which names the kind: {"verify": {..}}.
#ifndef KINEX_EXPERIMENTS_SWEEP_EXPERIMENT_H
#define KINEX_EXPERIMENTS_SWEEP_EXPERIMENT_H

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/formats/json_node.h"
#include "experiments/sweep/plan_cell.h"
#include "experiments/sweep/cell_run.h"

namespace kinex::sweep {

// What a plan takes of an experiment. In a plan file, in place of "blocks":
//   "select": {"experiment": "verify", "names": ["delaunay_2"], "quick": true,
//              "options": {"seeds": ["8"]}}
struct Selection {
  std::string experiment;
  std::vector<std::string> names;  // structures, or parts of a paper; empty: all
  bool quick = false;
  std::map<std::string, std::vector<std::string>> options;  // those of its own

  // "verify delaunay_2 --quick --seeds 8"
  std::string command() const;
};

struct Experiment {
  std::string name;
  std::string summary;
  // Throws InputError for a selection that it does not have.
  std::function<std::vector<PlanCell>(const Selection&)> cells;
};

// How cells of one kind are run, from the value of that member. Throws InputError for a cell that
// the program does not have.
struct CellKind {
  std::string_view member;
  CellReport (*run)(const formats::JsonNode& content);
};

struct Experiments {
  std::vector<Experiment> all;
  std::vector<CellKind> kinds;

  const Experiment* find(std::string_view name) const;
};

// Runs a cell of any kind in this process, from its text: the work of a child. Memory that is
// exhausted is reported, not thrown; a program error is thrown.
CellReport run_any(const std::string& text, const Experiments& experiments);

}  // namespace kinex::sweep

#endif
