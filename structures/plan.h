// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of a run: which structures are built for what a scene asks for, and which are shared.
#ifndef KINEX_STRUCTURES_PLAN_H
#define KINEX_STRUCTURES_PLAN_H

#include <limits>
#include <optional>
#include <vector>

#include "core/scene.h"
#include "core/simulator.h"

namespace kinex {

// A run has no more: 255 is the id of none.
inline constexpr std::size_t kMostStructures = std::numeric_limits<StructureId>::max();

// What is built for a scene: what it asks for, and what that reads.
struct PlannedStructure {
  Request request;
  bool asked = true;                   // false: it is there for others to read only
  std::optional<StructureId> watches;  // an earlier one of the plan
  int readers = 0;
};
// In the order of "maintain", but what is read comes before those who read it; structures that are
// read are shared by all who read them and by those who ask for them. The ids in the plan are those
// of its places.
std::vector<PlannedStructure> plan_structures(const Scene& scene);
// The place of the first structure of "maintain", which comes after what it reads. Requires a scene
// that asks for one.
StructureId asked_structure(const Scene& scene);
// Adds the plan to a simulator that has no structures yet.
void add_structures(Simulator& simulator, const Scene& scene);

}  // namespace kinex

#endif
