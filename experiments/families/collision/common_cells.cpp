// SPDX-License-Identifier: GPL-3.0-or-later
// Question: do the hard bounds of a structure for bodies hold, and its audits, on every kind of
//   scene: turning and not, near and far, with sharp bends of the path?
// Source: the bounds that the structure registers, each with its own.
// Parameters: 8 vertices (40 in full), 5 bodies where several are allowed.
// Expected: every bound holds, no audit finds a violation.
// Cost: about 1 s a structure.
#include <utility>

#include "experiments/families/collision/axes.h"
#include "experiments/families/collision/experiments.h"
#include "experiments/lab/workload.h"
#include "structures/registry.h"

namespace kinex::families {

namespace {

struct BodyScenes {
  const char* workload;
  int n, degree;
};

constexpr BodyScenes kBodyScenes[] = {
    {"polygon-random", 8, 1},   {"polygon-random", 8, 2},     {"polygon-random", 8, 3},
    {"polygons-in-box", 5, 1},  {"polygon-orbit-arcs", 8, 1}, {"polygon-spin-orbit", 8, 1},
    {"polygon-gears", 9, 1},    {"polygon-jitter", 8, 1},     {"polygon-kinks", 8, 1},
    {"polygon-approach", 8, 1},
};

}  // namespace

void add_common_body_cells(lab::Catalogue& catalogue, const StructureInfo& structure, lab::Extent extent) {
  if (!structure.bodies) return;
  for (const BodyScenes& scenes : kBodyScenes) {
    const lab::Workload* workload = lab::find_workload(scenes.workload);
    if (workload == nullptr) continue;
    lab::WorkloadParameters parameters;
    parameters.n = scenes.n;
    parameters.degree = scenes.degree;
    if (refusal_of(structure, lab::generate_scene(*workload, parameters))) continue;
    lab::Cell cell;
    cell.question = "Do the hard bounds hold?";
    cell.structure = structure.name;
    cell.workload = scenes.workload;
    cell.parameters.n = scenes.n;
    cell.parameters.degree = scenes.degree;
    cell.family = cell.workload_text();
    cell.axis = vertices_axis(cell);
    cell.random = workload->random;
    if (cell.random) cell.min_seeds = cell.max_seeds = 4;
    cell.audit = AuditLevel::kEvents;
    cell.cost = 0.3;
    catalogue.cells.push_back(cell);
    if (extent == lab::Extent::kQuick) continue;
    cell.parameters.n = 5 * scenes.n;
    cell.axis = vertices_axis(cell);
    if (cell.random) cell.min_seeds = cell.max_seeds = 8;
    cell.audit = AuditLevel::kEnd;
    cell.cost = 2;
    catalogue.cells.push_back(std::move(cell));
  }
}

}  // namespace kinex::families
