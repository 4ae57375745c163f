// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments of the program, as plans.
#ifndef KINEX_EXPERIMENTS_VERBS_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_VERBS_EXPERIMENTS_H

#include <string>
#include <vector>

#include "experiments/sweep/plan.h"

namespace CLI {
class App;
}

namespace kinex::verbs {

const sweep::Experiments& experiments();

// A plan on the command line: a file, or an experiment by its name and what is selected of it.
struct PlanWords {
  std::vector<std::string> words;  // "plan.json"; "verify", "delaunay_2"
  bool quick = false;
  std::vector<std::string> seeds, arithmetics;

  void add_options(CLI::App& verb);
  std::string command() const;  // as it was written
  // Throws InputError.
  sweep::Plan plan() const;
};

}  // namespace kinex::verbs

#endif
