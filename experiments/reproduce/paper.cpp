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
      {"separation-sensitive-1999",
       "J. Erickson, L. J. Guibas, J. Stolfi, L. Zhang, Separation-sensitive collision detection "
       "for "
       "convex objects, 1999",
       {{"translation", "how many certificates two polygons need that do not turn",
         separation_translation_points, separation_translation_report},
        {"rigid", "how many, and at what cost, when they turn", separation_rigid_points,
         separation_rigid_report},
        {"features", "what closest features and tangents cost at any distance",
         separation_features_points, separation_features_report},
        {"hysteresis", "certificates that last", separation_hysteresis_points,
         separation_hysteresis_report},
        {"hierarchies", "outer hierarchies of one polygon", separation_hierarchies_points, nullptr,
         separation_hierarchies_study}}},
  };
  return kPapers;
}

}  // namespace kinex
