// SPDX-License-Identifier: GPL-3.0-or-later
// The registry of structures: names to constructors.
#ifndef KINEX_STRUCTURES_REGISTRY_H
#define KINEX_STRUCTURES_REGISTRY_H

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/kernel.h"
#include "core/scene.h"
#include "core/structure.h"

namespace kinex {

struct StructureInfo {
  std::string_view name;     // as in "maintain"
  std::string_view summary;  // one line
  int min_dimension;         // axes that a scene must have
  bool uses_key;             // takes a "key"
  std::string_view reads;    // the structure, of the same key, that it watches; empty: none
  bool linear = false;       // for linear motions and keys (not squared distances) only
  bool bodies = false;       // for rigid bodies; otherwise for points
  bool collisions = false;   // maintains the pairs of bodies in contact
  bool unturned = false;     // for bodies that do not turn against each other only

  // A structure with a key also takes scenes of more axes; others would ignore some axes.
  bool any_dimension() const { return uses_key; }
  // The shape of its attribute.
  Attribute::Shape attribute_shape() const;
};

// All structures, in the order in which users see them.
const std::vector<StructureInfo>& structure_infos();
// nullptr if there is no such structure.
const StructureInfo* find_structure_info(std::string_view name);

// Makes the structure for `request`, with id `id` in `kernel`. Throws std::invalid_argument if the
// request is not valid for the scene (the scene reader checks that). `watched`: the structure that
// it reads (StructureInfo::reads), which outlives it.
std::unique_ptr<Structure> make_structure(const Request& request, const Scene& scene,
                                          Kernel& kernel, StructureId id,
                                          const Structure* watched = nullptr);

}  // namespace kinex

#endif
