// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of a run: which structures are built for a scene's requests, which are shared, and what
// numbers they need.
#ifndef KINEX_STRUCTURES_PLAN_H
#define KINEX_STRUCTURES_PLAN_H

#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "core/engine/simulator.h"
#include "core/motion/scene.h"

namespace kinex {

// The largest number of structures in a run: id 255 means none.
inline constexpr std::size_t kMostStructures = std::numeric_limits<StructureId>::max();

// A structure built for a scene: requested, or read by another one.
struct PlannedStructure {
  Request request;
  bool asked = true;                      // false: it exists for others to read only
  // Earlier ones of the plan, as its descriptor reads them, and the one that it shares, if any.
  std::vector<StructureId> watches = {};
  int readers = 0;
  std::vector<bool> members = {};  // by object, true for those that it is built from; empty: all
};
// In the order of "maintain", except that a structure comes before its readers. A structure that is
// read is shared by all its readers and by the requests for it. A part that two or more structures
// can share (StructureInfo::shares) is a structure, with the largest parameter that one of them
// needs; so it is if one structure and a request for that part can share it. Ids are places in the
// plan.
std::vector<PlannedStructure> plan_structures(const Scene& scene);
// The structures that one of the plan watches, given those made before it.
std::vector<const Structure*> watched_by(const PlannedStructure& planned,
                                         const Simulator& simulator);
// The place of the first structure of "maintain", which comes after what it reads. Requires a scene
// with a request.
StructureId asked_structure(const Scene& scene);
// What the plan's structures need beside the scene's own objects: the sum of what they declare.
NumberNeeds plan_numbers(const Scene& scene);
// The arithmetic of this name for the plan (core/arithmetic/arithmetic.h).
std::unique_ptr<Arithmetic> planned_arithmetic(std::string_view name, const Scene& scene);
// Adds the plan to a simulator that has no structures yet.
void add_structures(Simulator& simulator, const Scene& scene);

}  // namespace kinex

#endif
