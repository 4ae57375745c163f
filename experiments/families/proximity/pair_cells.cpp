// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: do closest pairs of two colours, nearest sites and cells of sites change exactly as often as counted by
//   hand, or by brute force? Do all structures of one attribute agree? Do they keep their bounds in
//   random motion?
// Sources: pass_along_row.cpp counts the changes of rows. Those of small integers, where the objects at even
//   and at odd places are the two colours, were counted by brute force over exact positions between all
//   critical times, by another program.
// Expected: the integers below, in every run; every hard bound, and every audit.
// Cost: about 10 s, some seconds more in full.
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/families/points/random_motion.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/cell_parts.h"
#include "experiments/lab/scene_change.h"

namespace kinex::families {
namespace {

constexpr const char* kBruteForce = "counted by brute force over exact positions";

constexpr int kLongestAuditedRow = 8;  // the longest row of which every event is audited

void add_counted(lab::Catalogue& catalogue, lab::Cell cell, std::string claim, int count,
                 std::string source) {
  cell.audit = cell.parameters.m <= kLongestAuditedRow ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.expectations.push_back(
      lab::expect_exactly(std::move(claim), "external", Integer(count), std::move(source)));
  catalogue.cells.push_back(std::move(cell));
}

// closest_pair_range_tree by quadrants in place of octants.
void in_quadrants(Scene& scene, int) { scene.maintain[0].parameters = {{"cones", Rational(4)}}; }

constexpr lab::SceneChange kInQuadrants{"in quadrants", in_quadrants};

struct Counted {
  int n, dimension;
  std::uint64_t seed;
  int pair, colours, nearest;  // of the first object
  int cell;                    // likewise; -1: not in the plane
  int maximum_norm = -1;       // of two colours; likewise
};

// All pairs of a red and a blue point are the closest in turn, in either norm (pass_along_row.cpp).
void add_colours_along_rows(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const std::string structure :
       {"bichromatic_pair_delaunay", "bichromatic_pair_all", "bichromatic_pair_maximum_norm"}) {
    for (const auto& [m, n] :
         {std::pair(2, 2), {3, 2}, {3, 3}, {4, 3}, {2, 5}, {8, 8}, {16, 8}, {8, 16}, {32, 32}}) {
      const bool large = n * m > 12;
      if (large && extent == lab::Extent::kQuick) continue;
      lab::Cell cell =
          lab::worst_case_cell(structure, "colours-along-row", n, 1, large ? 0.3 : 0.1);
      cell.parameters.m = m;
      const bool maximum_norm = structure == "bichromatic_pair_maximum_norm";
      add_counted(catalogue, std::move(cell),
                  maximum_norm ? structure + ".all_pairs" : "bichromatic_pair.all_pairs", n * m - 1,
                  "all nm pairs of two colours are the closest in turn: nm - 1");
    }
  }
}

void add_pairs_of_small_integers(lab::Catalogue& catalogue) {
  for (const Counted& one : {Counted{6, 2, 1, 4, 5, 1, 4 + 5, 4},
                             {8, 2, 1, 5, 3, 2, 4 + 4, 6},
                             {10, 2, 2, 8, 6, 4, 9 + 9, 7},
                             {12, 2, 3, 7, 5, 3, 6 + 5, 4},
                             {6, 3, 1, 4, 3, 1, -1},
                             {7, 3, 2, 7, 5, 3, -1},
                             {8, 3, 1, 5, 4, 1, -1}}) {
    const auto add = [&](const char* structure, const char* claim, int count,
                         const lab::SceneChange* change = nullptr) {
      lab::Cell cell = lab::worst_case_cell(structure, "small-integers", one.n, 1, 0.1);
      cell.parameters.seed = one.seed;
      cell.change = change;
      if (one.dimension != 2) cell.parameters.dimension = one.dimension;
      add_counted(catalogue, std::move(cell), claim, count, kBruteForce);
    };
    add("closest_pair_all", "closest_pair.small_integers", one.pair);
    add("bichromatic_pair_all", "bichromatic_pair.small_integers", one.colours);
    add("nearest_site", "nearest_site.small_integers", one.nearest);
    add("bichromatic_pair_delaunay", "bichromatic_pair.small_integers", one.colours);
    if (one.dimension != 2) continue;
    for (const char* structure : {"closest_pair_range_tree", "closest_pair_cones",
                                  "closest_pair_local", "closest_pair_bins"}) {
      add(structure, "closest_pair.small_integers", one.pair);
    }
    add("closest_pair_range_tree", "closest_pair.small_integers", one.pair, &kInQuadrants);
    add("voronoi_cell_2", "voronoi_cell.small_integers", one.cell);
    add("bichromatic_pair_maximum_norm", "bichromatic_pair_maximum_norm.small_integers",
        one.maximum_norm);
  }
}

}  // namespace

void add_pair_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const auto& [structure, change] :
       {std::pair<const char*, const lab::SceneChange*>("closest_pair_all", nullptr),
        {"closest_pair_range_tree", nullptr},
        {"closest_pair_range_tree", &kInQuadrants},
        {"closest_pair_cones", nullptr},
        {"closest_pair_local", nullptr},
        {"closest_pair_bins", nullptr}}) {
    for (const int size : {3, 4, 5, 8, 16, 32}) {
      if (size > 5 && extent == lab::Extent::kQuick) continue;
      lab::Cell cell = lab::worst_case_cell(structure, "pass-along-row", size, 1, 0.5);
      cell.parameters.m = size;
      cell.change = change;
      add_counted(catalogue, std::move(cell), "closest_pair.all_pairs", size * size - 1,
                  "all nm pairs are the closest in turn: nm - 1");
    }
  }
  add_colours_along_rows(catalogue, extent);
  add_pairs_of_small_integers(catalogue);
  for (const char* structure :
       {"closest_pair_all", "closest_pair_range_tree", "closest_pair_cones", "closest_pair_local",
        "closest_pair_bins", "bichromatic_pair_all", "bichromatic_pair_delaunay",
        "bichromatic_pair_maximum_norm", "nearest_site", "voronoi_cell_2"}) {
    const bool all_pairs = std::string_view(structure).ends_with("_all");
    for (const int n : {16, 64, 256}) {
      if (all_pairs && n > 64) continue;
      if (all_pairs && n > 16 && extent == lab::Extent::kQuick) continue;
      lab::Cell cell = uniform_cell(structure, n, 2);
      cell.precise = {{"external", kChangesError}};
      cell.cost = all_pairs ? n / 20.0 : n / 100.0;
      catalogue.cells.push_back(std::move(cell));
    }
  }
  for (const int n : {16, 64, 256}) {
    if (n > 64 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell = uniform_cell("closest_pair_range_tree", n, 2);
    cell.change = &kInQuadrants;
    cell.family = "uniform, in quadrants";
    cell.precise = {{"external", kChangesError}};
    cell.cost = n / 50.0;
    catalogue.cells.push_back(std::move(cell));
  }
  for (const int n : {16, 64}) {
    lab::Cell cell = uniform_cell("nearest_site", n, 3);
    cell.family = "uniform, 3 axes";
    cell.precise = {{"external", kChangesError}};
    cell.cost = n / 40.0;
    catalogue.cells.push_back(std::move(cell));
  }
}

}  // namespace kinex::families
