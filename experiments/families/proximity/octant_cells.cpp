// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: do the points that are next in an octant, and the trees in the maximum norm and in that
//   of a polygon that are read off such points, change exactly as often as counted by brute force, in
//   all structures? How many exchanges does random motion cause in four sorted lists, and
//   how many failures without them?
// Sources: pointers of small integers were counted by brute force over exact positions between all
//   critical times, by another program. In random motion the orders at 0 and at 1 are independent,
//   along every direction, so a list has n(n-1)/4 exchanges in expectation.
// Expected: the integers below, in every run; the mean; every hard bound, and every audit.
// Cost: about 10 s.
#include <cstdint>
#include <string_view>
#include <utility>

#include "experiments/families/points/random_motion.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/cell_parts.h"
#include "experiments/lab/scene_change.h"

namespace kinex::families {
namespace {

constexpr const char* kOctants[] = {"octants_listed", "octants_local"};
constexpr const char* kNormTrees[] = {"mst_maximum_norm_list",     "mst_maximum_norm_cycles",
                                      "mst_maximum_norm_clusters", "mst_polygon_list",
                                      "mst_polygon_cycles",        "mst_polygon_clusters"};

void add_octants_of_small_integers(lab::Catalogue& catalogue, const char* structure) {
  struct Pointers {
    int n;
    std::uint64_t seed;
    int first, second;  // changes in the two woods
  };
  for (const Pointers& one :
       {Pointers{6, 1, 49, 37}, {8, 1, 75, 62}, {10, 2, 116, 126}, {12, 3, 118, 82}}) {
    lab::Cell cell = lab::worst_case_cell(structure, "small-integers", one.n, 1, 0.1);
    cell.parameters.seed = one.seed;
    cell.audit = AuditLevel::kEvents;
    cell.expectations.push_back(lab::expect_exactly("octants.small_integers", "kind.point",
                                                    Integer(one.first + one.second),
                                                    "counted by brute force over exact positions"));
    catalogue.cells.push_back(std::move(cell));
  }
}

void add_random_octants(lab::Catalogue& catalogue, const char* structure, int n) {
  lab::Cell cell = uniform_cell(structure, n, 2);
  if (structure == std::string_view("octants_listed")) {
    cell.precise = {{"kind.order", 0.02}};
    cell.expectations.push_back(
        lab::expect_mean("octants_listed.uniform", "kind.order", n * (n - 1.0),
                         "E = n(n-1)/4 a list: independent orders; Guibas 1998, section 9"));
  } else {
    cell.precise = {{"external", kChangesError}};
  }
  cell.cost = n * n * 1e-4;
  catalogue.cells.push_back(std::move(cell));
}

bool is_polygon(std::string_view structure) { return structure.starts_with("mst_polygon"); }

void add_norm_trees_of_small_integers(lab::Catalogue& catalogue, const char* structure) {
  struct Swaps {
    int n;
    std::uint64_t seed;
    int maximum_norm, polygon;  // of 12 corners
  };
  const bool polygon = is_polygon(structure);
  for (const Swaps& one : {Swaps{6, 1, 10, 7}, {8, 1, 19, 13}}) {
    lab::Cell cell = lab::worst_case_cell(structure, "small-integers", one.n, 1, 0.1);
    cell.parameters.seed = one.seed;
    cell.audit = AuditLevel::kEvents;
    cell.expectations.push_back(lab::expect_exactly(
        polygon ? "mst_polygon.small_integers" : "mst_maximum_norm.small_integers", "external",
        Integer(polygon ? one.polygon : one.maximum_norm),
        "counted by brute force over exact positions"));
    catalogue.cells.push_back(std::move(cell));
  }
}

// A polygon of 20 corners in place of 12.
void of_20_corners(Scene& scene, int) {
  scene.maintain[0].over = {{.structure = "cones_local",
                             .label = "cones_local",
                             .key = {},
                             .parameters = {{"corners", Rational(20)}}}};
}

constexpr lab::SceneChange kOf20Corners{"of 20 corners", of_20_corners};

// Its swaps were not counted: every tree is compared with that of all pairs.
void add_trees_of_20_corners(lab::Catalogue& catalogue, const char* structure) {
  for (const int n : {6, 8}) {
    lab::Cell cell = lab::worst_case_cell(structure, "small-integers", n, 1, 0.2);
    cell.change = &kOf20Corners;
    cell.audit = AuditLevel::kEvents;
    catalogue.cells.push_back(std::move(cell));
  }
}

// Structures that sort have all exchanges of points that are far apart.
void add_exchanges(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const int n : {2, 3, 5, 8, 16, 32, 64}) {
    if (n > 8 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell =
        lab::worst_case_cell("octants_listed", "exchange-in-all-orders", n, 1, n > 8 ? 0.3 : 0.1);
    cell.audit = n <= 16 ? AuditLevel::kEvents : AuditLevel::kEnd;
    cell.expectations.push_back(
        lab::expect_exactly("octants_listed.exchanges", "kind.order", Integer(2 * n * (n - 1)),
                            "every pair exchanges its order in four lists: 4 C(n,2)"));
    catalogue.cells.push_back(std::move(cell));
  }
}

}  // namespace

void add_octant_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  add_exchanges(catalogue, extent);
  for (const char* const structure : kOctants) {
    add_octants_of_small_integers(catalogue, structure);
    for (const int n : {16, 64, 256}) {
      if (n > 64 && extent == lab::Extent::kQuick) continue;
      add_random_octants(catalogue, structure, n);
    }
  }
  for (const char* const structure : kNormTrees) {
    add_norm_trees_of_small_integers(catalogue, structure);
    if (is_polygon(structure)) {
      add_trees_of_20_corners(catalogue, structure);
      continue;  // its cones have many more events
    }
    for (const int n : {16, 64}) {
      if (n > 16 && extent == lab::Extent::kQuick) continue;
      lab::Cell cell = uniform_cell(structure, n, 2);
      cell.precise = {{"external", kChangesError}};
      cell.cost = n * n * 1e-3;
      catalogue.cells.push_back(std::move(cell));
    }
  }
}

}  // namespace kinex::families
