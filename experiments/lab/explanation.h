// SPDX-License-Identifier: GPL-3.0-or-later
// What a structure, a workload or an arithmetic is, in words: made from its descriptor, and for a
// structure from a small run, which has its certificates and its bounds.
#ifndef KINEX_EXPERIMENTS_LAB_EXPLANATION_H
#define KINEX_EXPERIMENTS_LAB_EXPLANATION_H

#include <string>
#include <utility>
#include <vector>

#include "experiments/lab/arithmetics.h"
#include "experiments/lab/workload.h"
#include "structures/parts/descriptor.h"

namespace kinex::lab {

// Lines under headings: {"ties", {"of equal keys ..", ..}}.
struct Explanation {
  std::string name, summary;
  std::vector<std::pair<std::string, std::vector<std::string>>> parts;
};

// Runs a scene of a few objects, some milliseconds.
Explanation explain(const StructureInfo& structure);
Explanation explain(const Workload& workload);
// "--n  objects: 100 by default, 1 at least", and so on: one line for each option of kinex gen that it takes.
std::vector<std::string> options_of(const Workload& workload);
Explanation explain(const ArithmeticInfo& arithmetic);

// The smallest scene of a workload that the structure can be maintained in.
struct ExampleScene {
  const Workload* workload = nullptr;  // nullptr: none
  WorkloadParameters parameters;
  std::string command;  // kinex gen ..
};
ExampleScene example_scene(const StructureInfo& structure);

}  // namespace kinex::lab

#endif
