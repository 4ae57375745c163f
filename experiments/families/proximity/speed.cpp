// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `bench/run speed` of this family. Each includes the triangulation that is read.
#include <string_view>
#include <utility>

#include "experiments/families/points/speed_rows.h"
#include "experiments/families/proximity/experiments.h"

namespace kinex::families {

std::vector<lab::SpeedRow> proximity_speed_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  std::vector<lab::SpeedRow> rows;
  for (const char* structure : {"closest_pair_delaunay", "emst_list", "emst_cycles"}) {
    rows.push_back(random_row(structure, 1, n(200)));
    rows.push_back(random_row(structure, 1, n(1000)));
  }
  rows.push_back(random_row("closest_pair_all", 1, n(50)));
  rows.push_back(random_row("bichromatic_pair_all", 1, n(50)));
  for (const char* structure :
       {"octants_listed", "octants_local", "closest_pair_range_tree", "closest_pair_cones",
        "closest_pair_local", "closest_pair_bins", "bichromatic_pair_delaunay", "nearest_site",
        "voronoi_cell_2"}) {
    rows.push_back(random_row(structure, 1, n(200)));
    rows.push_back(random_row(structure, 1, n(1000)));
  }
  for (const char* structure : {"mst_maximum_norm_list", "mst_maximum_norm_cycles"}) {
    rows.push_back(random_row(structure, 1, n(50)));
    rows.push_back(random_row(structure, 1, n(200)));
  }
  for (const char* structure : {"graph_mst_list", "graph_mst_cycles"}) {
    lab::SpeedRow row = random_row(structure, 1, n(200));
    row.workload = "random-graph";
    rows.push_back(std::move(row));
  }
  for (const char* structure : {"box_pairs", "disc_pairs_boxes", "disc_pairs_grid"}) {
    lab::SpeedRow row = random_row(structure, 1, n(200));
    row.workload = structure == std::string_view("box_pairs") ? "random-boxes" : "random-discs";
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace kinex::families
