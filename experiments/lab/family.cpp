// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/family.h"

#include "structures/registry.h"

namespace kinex::lab {

const FamilyExperiments* experiments_on(std::string_view structure) {
  for (const FamilyExperiments& family : experiment_families()) {
    if (family.name == family_of(structure)) return &family;
  }
  return nullptr;
}

std::string usual_structure(bool bodies, int dimension) {
  std::string_view found;
  for (const FamilyExperiments& family : experiment_families()) {
    for (const UsualStructure& usual : family.usual) {
      if (usual.bodies != bodies) continue;
      if (usual.dimension == dimension || (usual.dimension == 0 && found.empty())) {
        found = usual.structure;
      }
    }
  }
  return std::string(found);
}

}  // namespace kinex::lab
