// SPDX-License-Identifier: GPL-3.0-or-later
// Question: which structure for an attribute of points should one take? What each costs on the same
//   scenes: certificates, locality, responsiveness, external and internal events, CPU time.
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 3, for the
//   measures.
// Parameters: random motion of degree 1 and 2; random motion in which every object changes its flight
//   plan once on average, or three of four appear or disappear; two seeds, in full eight and larger n.
//   A scene that a structure of the group refuses is left out for that structure.
// Expected: every bound holds; what the structures of a group report is compared by tests.
// Cost: about 2 s a group.
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/points/experiments.h"
#include "experiments/lab/workload.h"
#include "structures/registry.h"

namespace kinex::families {

namespace {

struct GroupScenes {
  const char* workload;
  int n;
  int degree;
  bool full_only;
};

constexpr GroupScenes kGroupScenes[] = {
    {"uniform-square", 64, 1, false}, {"uniform-square", 256, 1, true},
    {"uniform-square", 32, 2, false}, {"new-plans", 64, 1, false},
    {"new-plans", 256, 1, true},      {"come-and-go", 64, 1, false},
    {"come-and-go", 256, 1, true},
};

lab::Cell cell_of(const StructureInfo& info, const GroupScenes& scenes, lab::Extent extent) {
  lab::Cell cell;
  cell.question = "Which structure for an attribute?";
  cell.structure = info.name;
  cell.workload = scenes.workload;
  cell.parameters.n = scenes.n;
  cell.parameters.degree = scenes.degree;
  cell.parameters.m = lab::find_workload(scenes.workload)->takes_m ? scenes.n : 0;
  cell.family = cell.workload_text();
  cell.random = true;
  cell.min_seeds = cell.max_seeds = extent == lab::Extent::kQuick ? 2 : 8;
  cell.audit = AuditLevel::kEnd;
  cell.cost = 0.2;
  return cell;
}

}  // namespace

void add_group_comparisons(lab::Catalogue& catalogue, lab::Extent extent) {
  std::map<std::string, std::vector<const StructureInfo*>> groups;
  for (const StructureInfo& info : structure_infos()) {
    // Structures of bodies and of keys have comparisons of their own; these scenes have no graphs,
    // colours or extents.
    if (info.group.empty() || info.bodies || info.uses_key || info.graph || info.colours) continue;
    if (info.extents != Extents::kNone || info.lines != LineUse::kNone) continue;
    groups[std::string(info.group)].push_back(&info);
  }
  for (const auto& [group, members] : groups) {
    if (members.size() < 2) continue;
    for (const StructureInfo* info : members) {
      for (const GroupScenes& scenes : kGroupScenes) {
        if (scenes.full_only && extent == lab::Extent::kQuick) continue;
        if (scenes.degree > info->largest_degree) continue;
        const lab::Cell wanted = cell_of(*info, scenes, extent);
        auto cell =
            std::find_if(catalogue.cells.begin(), catalogue.cells.end(), [&](const lab::Cell& c) {
              return c.structure == wanted.structure && c.workload == wanted.workload &&
                     !c.mirrored && c.parameters.n == scenes.n &&
                     c.parameters.degree == scenes.degree && c.parameters.dimension == 0;
            });
        if (cell == catalogue.cells.end()) cell = catalogue.cells.insert(cell, wanted);
        cell->comparison = group;
      }
    }
  }
}

}  // namespace kinex::families
