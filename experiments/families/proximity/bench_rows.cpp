// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the benchmarks of this family. Each run includes the triangulation, octants or
// lists that are read.
#include "experiments/families/points/bench_rows.h"
#include "experiments/families/proximity/experiments.h"

namespace kinex::families {

namespace {

lab::BenchRow with_axes(int dimension, lab::BenchRow row) {
  row.parameters.dimension = dimension;
  return row;
}

}  // namespace

std::vector<lab::BenchRow> proximity_bench_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  std::vector<lab::BenchRow> rows;
  for (const char* structure : {"closest_pair_delaunay", "emst_cycles"}) {
    for (const int size : {200, 1000}) rows.push_back(random_row(structure, 1, n(size)));
  }
  // Some of the whole runs would take minutes: the first events tell as much.
  rows.push_back(random_row("emst_list", 1, n(200)));
  rows.push_back(random_row("emst_list", 1, n(1000), 2'000'000));
  rows.push_back(random_row("emst_clusters", 1, n(200)));
  rows.push_back(random_row("emst_clusters", 1, n(1000), 30'000));
  rows.push_back(random_row("emst_cycles", 1, n(4000), 60'000));
  for (const char* structure : {"closest_pair_all", "bichromatic_pair_all"}) {
    rows.push_back(with_axes(2, random_row(structure, 1, n(50))));
  }
  for (const char* structure : {"closest_pair_range_tree", "bichromatic_pair_maximum_norm"}) {
    for (const int size : {200, 1000}) rows.push_back(random_row(structure, 1, n(size), 150'000));
  }
  // Insertions and erasures.
  for (const char* structure :
       {"closest_pair_range_tree", "closest_pair_local", "closest_pair_delaunay", "emst_cycles"}) {
    auto row = lab::speed_row(structure, "come-and-go", 1, n(1000));
    row.events = 150'000;
    rows.push_back(with_axes(2, row));
  }
  for (const char* structure : {"octants_listed", "octants_local", "closest_pair_cones",
                                "closest_pair_local", "closest_pair_bins",
                                "bichromatic_pair_delaunay", "nearest_site", "voronoi_cell_2"}) {
    for (const int size : {200, 1000}) rows.push_back(random_row(structure, 1, n(size)));
  }
  for (const char* structure :
       {"nearest_site", "emst_cycles", "closest_pair_delaunay", "bichromatic_pair_delaunay"}) {
    rows.push_back(with_axes(3, random_row(structure, 1, n(500))));
  }
  for (const char* structure : {"emst_list", "emst_clusters"}) {
    rows.push_back(with_axes(3, random_row(structure, 1, n(100))));
  }
  rows.push_back(random_row("closest_pair_local", 1, n(10000), 1'500'000));
  for (const char* structure : {"cones_local", "mst_maximum_norm_list", "mst_maximum_norm_cycles",
                                "mst_maximum_norm_clusters", "mst_polygon_list",
                                "mst_polygon_cycles", "mst_polygon_clusters"}) {
    for (const int size : {50, 200}) rows.push_back(random_row(structure, 1, n(size)));
  }
  for (const char* structure : {"graph_mst_list", "graph_mst_cycles", "graph_mst_clusters",
                                "graph_mst_sparsified"}) {
    rows.push_back(lab::speed_row(structure, "random-graph", 1, n(200)));
  }
  rows.push_back(with_axes(2, lab::speed_row("box_pairs", "random-boxes", 1, n(200))));
  for (const char* structure : {"disc_pairs_all", "disc_pairs_boxes", "disc_pairs_grid"}) {
    rows.push_back(with_axes(2, lab::speed_row(structure, "random-discs", 1, n(200))));
  }
  // On one axis discs touch just when their ends do.
  rows.push_back(lab::speed_row("disc_pairs_boxes", "random-discs", 1, n(100)));
  for (const int size : {200, 1000}) {
    rows.push_back(lab::speed_row("closest_pair_discs", "apart-discs", 1, n(size)));
  }
  rows.push_back(with_axes(3, lab::speed_row("closest_pair_discs", "apart-discs", 1, n(100))));
  return rows;
}

}  // namespace kinex::families
