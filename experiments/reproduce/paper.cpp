// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproduce/part.h"

namespace kinex {

const std::vector<Paper>& papers() {
  static const std::vector<Paper> kPapers{
      {"kds-report-1998",
       "L. J. Guibas, Kinetic data structures: a state of the art report, 1998",
       {{"figure-3", "the cost of three ways to keep a convex hull", kds_figure_3_points,
         kds_figure_3_report},
        {"large-runs", "the hull of 50,000 and of 1,000,000 points (section 11)",
         kds_large_runs_points, kds_large_runs_report},
        {"section-9", "how many events random motion causes", kds_section_9_points,
         kds_section_9_report}}},
  };
  return kPapers;
}

}  // namespace kinex
