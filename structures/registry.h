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
  bool uses_key;             // a "key" makes sense for it
  std::string_view reads;    // the structure, of the same key, that it watches; empty: none
  bool linear = false;       // for linear motions and keys (not squared distances) only
  bool bodies = false;       // for rigid bodies; otherwise for points
  bool collisions = false;   // maintains which of the bodies are in contact
  bool unturned = false;     // for bodies that do not turn against each other only

  // What has a key takes scenes of more axes, too; others would leave them out of account.
  bool any_dimension() const { return uses_key; }
  // Of what it maintains.
  Attribute::Shape attribute_shape() const;
};

// All structures, in the order in which they are listed to people.
const std::vector<StructureInfo>& structure_infos();
// nullptr if there is no such structure.
const StructureInfo* find_structure_info(std::string_view name);

// Makes the structure that `request` asks for, with id `id` in `kernel`. The request must be valid
// for the scene (checked by the scene reader): otherwise std::invalid_argument. `watched`: the
// structure that it reads (StructureInfo::reads), which outlives it.
std::unique_ptr<Structure> make_structure(const Request& request, const Scene& scene,
                                          Kernel& kernel, StructureId id,
                                          const Structure* watched = nullptr);

}  // namespace kinex

#endif
