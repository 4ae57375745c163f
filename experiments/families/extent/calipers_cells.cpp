// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: do the diameter, the width and the rectangles change exactly as often as counted by
//   hand, and like n^2? Does the baseline report the same changes? Are all bounds kept in random motion? How many
//   events have the calipers?
// Source: vernier.cpp counts nm - 1 changes of the diameter, (n - 1)(m - 1) + n of the antipodal
//   pairs, 2nm - n - m of the width and of both rectangles; (n - 1)(m - 1) + 2m pairs of edges that
//   become perpendicular in the turned vernier. Its width changes twice.
// Expected: the integers below, in every run; every hard bound, and every audit.
// Cost: quick about 20 s, in full 4 minutes.
#include <string>
#include <utility>

#include "experiments/families/extent/calipers_experiments.h"
#include "experiments/families/extent/quadratic_families.h"
#include "experiments/families/points/random_motion.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {
namespace {

void add_vernier(lab::Catalogue& catalogue, const std::string& structure, int size) {
  lab::Cell cell = lab::worst_case_cell(structure, "vernier", size, 1, 0.3);
  set_both_sizes(cell, size);
  cell.audit = size <= 6 ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.expectations.push_back(lab::expect_exactly(
      structure + ".vernier", "external", Integer(size * size - 1),
      "the nearest of nm angles to one that passes all of them: nm - 1 changes"));
  catalogue.cells.push_back(std::move(cell));
}

// The antipodal pairs that the vernier's diameters are among.
void add_antipodal(lab::Catalogue& catalogue, int size) {
  lab::Cell cell = lab::worst_case_cell("calipers_2", "vernier", size, 1, 0.3);
  set_both_sizes(cell, size);
  cell.audit = size <= 6 ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.expectations.push_back(lab::expect_exactly(
      "calipers_2.vernier", "external", Integer((size - 1) * (size - 1) + size),
      "(n - 1)(m - 1) pairs of edges become antiparallel, and the hull changes n times"));
  cell.expectations.push_back(
      lab::expect_exactly("calipers_2.vernier.antiparallel", "kind.antiparallel",
                          Integer((size - 1) * (size - 1)), "the pairs of edges of the two arcs"));
  catalogue.cells.push_back(std::move(cell));
}

// The width in spite of them.
void add_vernier_width(lab::Catalogue& catalogue, int size) {
  lab::Cell cell = lab::worst_case_cell("width_2", "vernier", size, 1, 0.3);
  set_both_sizes(cell, size);
  cell.audit = size <= 6 ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.expectations.push_back(lab::expect_exactly("width_2.vernier", "external", Integer(2),
                                                  "the strip is flush with the arc at rest but twice"));
  catalogue.cells.push_back(std::move(cell));
}

// The edges that become perpendicular in the turned vernier, for a rectangle's calipers.
void add_perpendicular(lab::Catalogue& catalogue, const std::string& structure, int size) {
  lab::Cell cell = lab::worst_case_cell(structure, "vernier-turned", size, 1, 0.5);
  set_both_sizes(cell, size);
  cell.audit = size <= 6 ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.expectations.push_back(lab::expect_exactly(
      structure + ".vernier_turned", "kind.perpendicular",
      Integer((size - 1) * (size - 1) + 2 * size),
      "(n - 1)(m - 1) pairs of edges of the two arcs; 2m with the edges between the arcs"));
  catalogue.cells.push_back(std::move(cell));
}

void add_comb(lab::Catalogue& catalogue, const std::string& structure, int size) {
  lab::Cell cell = lab::worst_case_cell(structure, "comb", size, 1, 0.5);
  set_both_sizes(cell, size);
  cell.audit = size <= 4 ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.expectations.push_back(lab::expect_exactly(
      structure + ".comb", "external", Integer(2 * size * size - 2 * size),
      "n tips pass m edges, and n - 1 edges of two tips pass m edges: 2nm - n - m changes"));
  catalogue.cells.push_back(std::move(cell));
}

void add_through_point(lab::Catalogue& catalogue, const std::string& structure) {
  lab::Cell cell = lab::worst_case_cell(structure, "through-point", 8, 1, 0.1);
  cell.audit = AuditLevel::kEvents;
  cell.expectations.push_back(
      lab::expect_exactly(structure + ".through_point", "external", Integer(0),
                          "all points meet, and go on to the opposite sides"));
  catalogue.cells.push_back(std::move(cell));
}

}  // namespace

std::vector<lab::Workload> caliper_workloads() {
  lab::Workload vernier{"vernier",
                        "--n points at rest, --m move: nm - 1 changes of the diameter",
                        2, 2, 2, false, false, true, "diameter_2", generate_vernier, 2, 1};
  lab::Workload turned{"vernier-turned",
                       "the vernier with its points at rest turned by 90 degrees: (n - 1)(m - 1) edges "
                       "become perpendicular",
                       2, 2, 2, false, false, true, "min_area_rectangle_2", generate_vernier_turned, 2, 1};
  lab::Workload comb{"comb",
                     "--n tips pass --m edges: 2nm - n - m changes of width and rectangles",
                     2, 2, 2, false, false, true, "width_2", generate_comb, 1, 2};
  lab::Workload through{"through-point",
                        "--n points pass through one point at one instant: no extent changes",
                        2, 2, 2, false, false, false, "diameter_2", generate_through_point, 1};
  std::vector<lab::Workload> all{vernier, turned, comb, through};
  lab::set_sizes(all, {{"vernier", "points at rest", "moving points"},
                       {"vernier-turned", "points at rest", "moving points"},
                       {"comb", "tips", "edges"}});
  return all;
}

std::vector<lab::TradePlan> caliper_trade() {
  std::vector<lab::TradePlan> plans{{"calipers_2", 2, {12, 32}, "vernier", {4, 8}, {16, 36},
                                     {8, 16}, {{8, 16, 32}, {8, 16, 32, 64}}}};
  for (const char* diameter : {"diameter_2", "diameter_all_pairs"}) {
    plans.push_back({diameter, 2, {12, 32}, "vernier", {4, 8}, {16, 36}, {8, 16},
                     {{8, 16, 32}, {8, 16, 32, 64}}});
  }
  for (const char* flush : {"width_2", "min_area_rectangle_2", "min_perimeter_rectangle_2"}) {
    plans.push_back({flush, 2, {8, 32}, "comb", {3, 6}, {9, 36}, {8, 16},
                     {{8, 16}, {8, 16, 32, 64}}});
  }
  return plans;
}

void add_caliper_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const int size : kWorstSizes) {
    if (size > kLargestQuickSize && extent == lab::Extent::kQuick) continue;
    add_antipodal(catalogue, size);
    add_vernier_width(catalogue, size);
    for (const char* structure : {"min_area_rectangle_2", "min_perimeter_rectangle_2"}) {
      add_perpendicular(catalogue, structure, size);
    }
    for (const char* structure : {"diameter_2", "diameter_all_pairs"}) {
      add_vernier(catalogue, structure, size);
    }
    for (const char* structure : {"width_2", "min_area_rectangle_2", "min_perimeter_rectangle_2"}) {
      add_comb(catalogue, structure, size);
    }
  }
  const auto grows = [&](const std::string& structure, const char* workload,
                         const char* quantity) {
    catalogue.growths.push_back(quadratic_growth(structure, workload, quantity));
  };
  grows("calipers_2", "vernier", "kind.antiparallel");
  for (const char* structure : {"min_area_rectangle_2", "min_perimeter_rectangle_2"}) {
    grows(structure, "vernier-turned", "kind.perpendicular");
  }
  for (const char* structure : {"diameter_2", "diameter_all_pairs"}) {
    grows(structure, "vernier", "external");
  }
  for (const char* structure : {"width_2", "min_area_rectangle_2", "min_perimeter_rectangle_2"}) {
    grows(structure, "comb", "external");
  }
  for (const char* structure :
       {"calipers_2", "diameter_2", "width_2", "min_area_rectangle_2", "min_perimeter_rectangle_2"}) {
    add_through_point(catalogue, structure);
    for (const int n : {16, 64}) {
      lab::Cell cell = uniform_cell(structure, n, 2);
      cell.cost = n / 50.0;
      catalogue.cells.push_back(std::move(cell));
    }
  }
}

}  // namespace kinex::families
