// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the benchmarks of this family.
#include "experiments/families/points/bench_rows.h"
#include "experiments/families/extent/experiments.h"

namespace kinex::families {

std::vector<lab::BenchRow> extent_bench_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  std::vector<lab::BenchRow> rows;
  // On a hull: the time includes the hull's.
  for (const char* structure : {"calipers_2", "diameter_2", "width_2", "min_area_rectangle_2",
                                "min_perimeter_rectangle_2", "bounding_box_2_hull"}) {
    for (const int size : {1000, 10000}) rows.push_back(random_row(structure, 1, n(size)));
  }
  // Beside the hull's row of this size.
  rows.push_back(random_row("diameter_2", 1, n(100000)));
  rows.back().rounds = 2;
  rows.push_back(random_row("diameter_all_pairs", 1, n(200)));
  for (const int size : {1000, 10000}) {
    rows.push_back(random_row("bounding_box", 1, n(size)));
    rows.back().parameters.dimension = 2;
  }
  // Certificates of degree 2 and 6, where doubles handle other events.
  for (const char* structure :
       {"diameter_2", "width_2", "min_area_rectangle_2", "min_perimeter_rectangle_2"}) {
    rows.push_back(plane_row("same_questions", structure, 1, n(10000), 3));
    rows.push_back(plane_row("same_questions", structure, 1, n(16), 3));
    rows.back().workload = "comb";
    rows.back().parameters.m = n(16);
  }
  rows.push_back(random_row("farthest_delaunay_2", 1, n(1000)));
  rows.push_back(random_row("min_circle_2", 1, n(1000)));
  rows.push_back(lab::speed_row("min_circle_2", "seesaw", 1, n(32)));
  rows.back().parameters.m = n(32);
  rows.push_back(random_row("min_circle_2_brute_force", 1, n(200)));
  for (const char* structure :
       {"directions_2", "directions_2_tournament", "diameter_directions", "width_directions",
        "min_perimeter_rectangle_directions", "min_area_rectangle_directions"}) {
    rows.push_back(lab::speed_row(structure, "box-worst", 1, n(1000)));
  }
  return rows;
}

}  // namespace kinex::families
