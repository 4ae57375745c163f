// SPDX-License-Identifier: GPL-3.0-or-later
// Question: do the hard bounds of a structure for points hold, and its audits, on every kind of
//   scene: other motions, higher degrees, and scenes full of simultaneous and degenerate events?
// Source: the bounds that the structure registers, each with its own.
// Parameters: n = 16 (12 where there are ties), audited after every event, one seed; in full also n = 96 (48) and
//   four seeds, audited at the end. Structures with long audits: n = 9 (8), and 48 (24).
// Expected: every bound holds, no audit finds a violation.
// Cost: less than 1 s a structure.
#include <algorithm>
#include <string_view>
#include <utility>

#include "experiments/families/points/experiments.h"
#include "experiments/lab/family.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

namespace {

struct Scenes {
  const char* workload;
  int degree;
  int min_dimension;
  bool degenerate;
};

constexpr Scenes kScenes[] = {
    {"uniform-square", 2, 1, false},
    {"uniform-square", 3, 1, false},
    {"uniform-disk", 1, 1, false},
    {"gaussian", 1, 1, false},
    {"static-one-mover", 1, 1, false},
    {"new-plans", 1, 1, false},
    {"come-and-go", 1, 1, false},
    {"grid", 1, 1, true},
    {"lattice", 1, 1, true},
    {"meet", 1, 1, true},
    {"through-one-point", 1, 1, true},
    {"collinear-instant", 1, 2, true},
    {"expanding-circle", 1, 2, true},
    {"rotating-circle", 2, 2, true},
    {"counter-rotating-rings", 2, 2, true},
};

bool has_long_audits(std::string_view structure) {
  const lab::FamilyExperiments* family = lab::experiments_on(structure);
  return family != nullptr && std::count(family->long_audits.begin(), family->long_audits.end(), structure) > 0;
}

}  // namespace

void add_common_point_cells(lab::Catalogue& catalogue, const StructureInfo& structure, lab::Extent extent) {
  if (structure.bodies) return;
  const bool long_audits = has_long_audits(structure.name);
  for (const Scenes& scenes : kScenes) {
    const lab::Workload* workload = lab::find_workload(scenes.workload);
    const int dimension = std::max(structure.min_dimension, scenes.min_dimension);
    if (dimension > structure.min_dimension || workload == nullptr ||
        dimension > workload->max_dimension) {
      continue;  // for one-dimensional structures a scene in the plane adds nothing
    }
    if (structure.linear() && scenes.degree > 1) continue;
    lab::Cell cell;
    cell.question = "Do the hard bounds hold?";
    cell.structure = structure.name;
    cell.workload = scenes.workload;
    cell.parameters.n = long_audits ? (scenes.degenerate ? 8 : 9) : (scenes.degenerate ? 12 : 16);
    cell.parameters.degree = workload->takes_degree ? scenes.degree : 1;
    cell.parameters.dimension = dimension == workload->default_dimension ? 0 : dimension;
    cell.family = cell.workload_text();
    cell.random = workload->random;
    cell.audit = AuditLevel::kEvents;
    cell.cost = 0.2;
    catalogue.cells.push_back(cell);
    if (extent == lab::Extent::kQuick) continue;
    cell.parameters.n = (scenes.degenerate ? 48 : 96) / (long_audits ? 2 : 1);
    if (cell.random) cell.min_seeds = cell.max_seeds = 4;
    cell.audit = AuditLevel::kEnd;
    cell.cost = 1;
    catalogue.cells.push_back(std::move(cell));
  }
}

}  // namespace kinex::families
