// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/maximum/family.h"

#include "experiments/families/maximum/experiments.h"
#include "experiments/families/maximum/workloads.h"

namespace kinex::families {

lab::FamilyExperiments maximum_experiments() {
  lab::FamilyExperiments family;
  family.name = "maximum";
  family.workloads = {
      {"tournament-worst", "n log2(n) - n + 1 failures of a kinetic tournament; n a power of two",
       1, 1, 1, false, false, false, "maximum_tournament", generate_tournament_worst},
      {"heap-worst", "as many failures of a kinetic heap as the sum of its depths", 1, 1, 1, false,
       false, false, "maximum_heap", generate_heap_worst}};
  family.workloads.front().default_n = 64;
  family.add_cells = add_maximum_cells;
  family.add_comparisons = add_maximum_comparison;
  family.studies = {{"maximum_hanger", "maximum", "maximum_hanger", study_hanger}};
  family.trade = {{"maximum_tournament",
                   1,
                   {64, 256},
                   "tournament-worst",
                   {32, 128},
                   {64, 256},
                   {32, 128},
                   {{16, 64, 256, 1024}, {16, 64, 256, 1024, 4096}}},
                  {"maximum_heap",
                   1,
                   {64, 256},
                   "heap-worst",
                   {31, 127},
                   {64, 256},
                   {32, 128},
                   {{16, 64, 256, 1024}, {16, 64, 256, 1024, 4096}}}};
  family.bench_rows = maximum_bench_rows;
  return family;
}

}  // namespace kinex::families
