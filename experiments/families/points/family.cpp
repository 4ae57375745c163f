// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/family.h"

#include "experiments/families/points/bench_rows.h"
#include "experiments/families/points/experiments.h"
#include "experiments/families/points/workloads.h"

namespace kinex::families {

lab::FamilyExperiments point_experiments() {
  lab::FamilyExperiments family;
  family.name = "points";
  family.workloads = point_workloads();
  family.add_common_cells = add_common_point_cells;
  family.add_comparisons = add_group_comparisons;
  family.bench_rows = point_bench_rows;
  family.papers = {kds_report({{"section-9", "how many events random motion causes", 3,
                                kds_section_9_points, kds_section_9_report}})};
  return family;
}

}  // namespace kinex::families
