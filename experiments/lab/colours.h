// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of a scene's objects, in its requests.
#ifndef KINEX_EXPERIMENTS_LAB_COLOURS_H
#define KINEX_EXPERIMENTS_LAB_COLOURS_H

#include <algorithm>
#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "structures/registry.h"

namespace kinex::lab {

// Lets requests for structures of two colours that name none name those of the objects, in the order in
// which they come, if these have two.
inline void name_colours(Scene& scene) {
  std::vector<std::string> colours;
  for (const SceneObject& object : scene.objects) {
    if (object.colour.empty() ||
        std::find(colours.begin(), colours.end(), object.colour) != colours.end()) {
      continue;
    }
    colours.push_back(object.colour);
  }
  if (colours.size() != 2) return;
  for (Request& request : scene.maintain) {
    const StructureInfo* const info = find_structure_info(request.structure);
    if (info != nullptr && info->colours && request.colours.empty()) request.colours = colours;
  }
}

}  // namespace kinex::lab

#endif
