// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/hull/family.h"

#include "experiments/families/hull/experiments.h"
#include "experiments/families/hull/workloads.h"
#include "experiments/families/points/experiments.h"

namespace kinex::families {

lab::FamilyExperiments hull_experiments() {
  lab::FamilyExperiments family;
  family.name = "hull";
  family.workloads = {{"hull-worst",
                       "a convex hull of --m slow and --n moving points that changes 2nm - 1 times",
                       2, 2, 2, false, false, true, "convex_hull_2", generate_hull_worst}};
  lab::set_sizes(family.workloads, {{"hull-worst", "moving points", "slow points"}});
  family.add_cells = add_hull_cells;
  family.studies = {{"convex_hull_2", "convex_hull", "convex_hull_2", study_hull_locality}};
  family.trade = {{"convex_hull_2",
                   2,
                   {24, 64},
                   "hull-worst",
                   {4, 8},
                   {16, 36},
                   {12, 24},
                   {{8, 16, 32, 64}, {8, 16, 32, 64, 128, 256}}}};
  family.papers = {
      kds_report({{"figure-3", "the cost of three ways to keep a convex hull", 1,
                   kds_figure_3_points, kds_figure_3_report},
                  {"large-runs", "the hull of 50,000 and of 1,000,000 points (section 11)", 2,
                   kds_large_runs_points, kds_large_runs_report}})};
  family.bench_rows = hull_bench_rows;
  return family;
}

}  // namespace kinex::families
