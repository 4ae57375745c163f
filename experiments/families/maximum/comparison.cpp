// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what do the structures for a maximum cost on the same scenes? Responsiveness, locality,
//   compactness and efficiency of each.
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5, for the
//   structures and for the worst cases of tournament and heap; cells.cpp and uniform_lines.h.
// Parameters: the two worst-case families; random motion, of degree 1 to 3; random motion in which
//   every object changes its flight plan once on average, or three of four appear or disappear;
//   eight seeds where there are no other experiments on the same scenes.
// Expected: the same number of changes of the maximum in all structures; the sorted list swaps all
//   pairs; the envelope and the dual hull have no internal events.
// Cost: about 10 s.
#include <algorithm>
#include <string>
#include <utility>

#include "experiments/families/maximum/envelope_witness.h"
#include "experiments/families/maximum/experiments.h"
#include "experiments/lab/cell_parts.h"
#include "experiments/lab/workload.h"
#include "structures/registry.h"

namespace kinex::families {

namespace {

constexpr int kSeeds = 8;

struct Family {
  const char* workload;
  int n;
  int degree;
  bool full_only;
};

constexpr Family kFamilies[] = {
    {"tournament-worst", 64, 1, false}, {"tournament-worst", 256, 1, false},
    {"heap-worst", 63, 1, false},       {"heap-worst", 255, 1, true},
    {"uniform-square", 256, 1, false},  {"uniform-square", 1024, 1, false},
    {"uniform-square", 24, 2, false},   {"uniform-square", 24, 3, false},
    {"new-plans", 64, 1, false},        {"new-plans", 256, 1, false},
    {"new-plans", 1024, 1, false},      {"come-and-go", 64, 1, false},
    {"come-and-go", 256, 1, false},     {"come-and-go", 1024, 1, false},
};

lab::Cell new_cell(const std::string& structure, const Family& family) {
  lab::Cell cell;
  cell.structure = structure;
  cell.workload = family.workload;
  cell.parameters.n = family.n;
  cell.parameters.degree = family.degree;
  cell.random = lab::find_workload(family.workload)->random;
  cell.bounded = true;
  cell.parameters.m = lab::find_workload(family.workload)->takes_m ? family.n : 0;
  // Audits at events compute signs, too; where changes are to be measured they are made at the end.
  const bool changes =
      lab::find_workload(family.workload)->takes_m || family.workload == std::string("come-and-go");
  cell.audit = family.n <= 64 && !changes ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.cost = 0.3;
  if (cell.random) {
    cell.parameters.dimension = 1;
    cell.min_seeds = cell.max_seeds = kSeeds;
    cell.family = family.workload == std::string("uniform-square") ? "uniform" : family.workload;
    if (family.degree == 1 && cell.family == "uniform") {
      cell.expectations.push_back(
          lab::expect_witness("maximum.envelope", "external", upper_envelope_changes,
                         "breakpoints of the envelope, from the lines sorted by slope"));
    }
    return cell;
  }
  cell.family = family.workload;
  cell.expectations.push_back(
      lab::expect_exactly("maximum.worst_case", "external", Integer(family.n - 1),
                     "all lines are on the envelope: n - 1; Guibas 1998, section 5"));
  if (structure == "maximum_sorted_list") {
    cell.expectations.push_back(lab::expect_exactly("maximum.sorted_list.swaps", "processed",
                                               pairs(Integer(family.n)),
                                               "any two lines cross: n(n-1)/2 swaps"));
  }
  return cell;
}

}  // namespace

void add_maximum_comparison(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const StructureInfo& info : structure_infos()) {
    if (info.group != "maximum") continue;
    const std::string structure(info.name);
    for (const Family& family : kFamilies) {
      if (family.full_only && extent == lab::Extent::kQuick) continue;
      if (info.linear() && family.degree > 1) continue;
      auto cell = std::find_if(catalogue.cells.begin(), catalogue.cells.end(), [&](const lab::Cell& c) {
        return c.structure == structure && c.workload == family.workload && !c.mirrored &&
               c.parameters.n == family.n && c.parameters.degree == family.degree;
      });
      if (cell == catalogue.cells.end()) {
        catalogue.cells.push_back(new_cell(structure, family));
        catalogue.cells.back().question = "What does it cost to maintain a maximum?";
        cell = catalogue.cells.end() - 1;
      }
      cell->comparison = "maximum";
      if (structure == "maximum_envelope" || structure == "maximum_dual_hull") {
        cell->expectations.push_back(
            lab::expect_exactly("maximum.no_internal_events", "internal", Integer(0),
                           "every event changes the maximum; Guibas 1998, section 5"));
      }
    }
  }
}

}  // namespace kinex::families
