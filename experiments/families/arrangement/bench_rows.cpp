// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the benchmarks of this family.
#include "experiments/families/arrangement/experiments.h"

namespace kinex::families {

namespace {

// As many lines as points, each at most twice on each line.
lab::BenchRow passing_row(std::string_view structure, int n) {
  lab::BenchRow row = lab::speed_row(structure, "points-through-lines", 1, n);
  row.parameters.m = n;
  return row;
}

}  // namespace

// Where three lines meet three certificates fail. Their roots are equal, but doubles round them by the order
// of the lines: half of the triples of random lines fall apart into two or three instants, each with a report
// of its own, and the repairs of a cutting do not end. In three bundles, whose triples meet at integers, and
// of points that pass through lines, one certificate at an instant, doubles report what `exact` does.
std::vector<lab::BenchRow> arrangement_bench_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  return {lab::speed_row("incidences_all", "random-lines-and-points", 1, n(200)),
          lab::speed_row("incidences_cutting", "random-lines-and-points", 1, n(64)),
          passing_row("incidences_cutting", n(32)),
          lab::speed_row("line_arrangement_2", "random-lines", 1, n(48)),
          lab::speed_row("line_arrangement_2", "three-bundles", 1, n(48)),
          lab::speed_row("points_in_arrangement", "random-lines-and-points", 1, n(64)),
          passing_row("points_in_arrangement", n(32)),
          lab::speed_row("trapezoids_2", "random-lines", 1, n(24)),
          lab::speed_row("trapezoids_2", "three-bundles", 1, n(24)),
          lab::speed_row("closest_point_line", "random-lines-and-points", 1, n(64)),
          lab::speed_row("closest_point_line_vertical", "random-lines-and-points", 1, n(64))};
}

}  // namespace kinex::families
