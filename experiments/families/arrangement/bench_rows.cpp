// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the benchmarks of this family.
#include "experiments/families/arrangement/experiments.h"

namespace kinex::families {

std::vector<lab::BenchRow> arrangement_bench_rows(int scale) {
  return {
      lab::speed_row("incidences_all", "random-lines-and-points", 1, lab::scaled_size(200, scale)),
      lab::speed_row("incidences_cutting", "random-lines-and-points", 1,
                     lab::scaled_size(64, scale)),
      lab::speed_row("line_arrangement_2", "random-lines", 1, lab::scaled_size(48, scale)),
      lab::speed_row("points_in_arrangement", "random-lines-and-points", 1,
                     lab::scaled_size(64, scale)),
      lab::speed_row("trapezoids_2", "random-lines", 1, lab::scaled_size(24, scale)),
      lab::speed_row("closest_point_line", "random-lines-and-points", 1,
                     lab::scaled_size(64, scale)),
      lab::speed_row("closest_point_line_vertical", "random-lines-and-points", 1,
                     lab::scaled_size(64, scale))};
}

}  // namespace kinex::families
