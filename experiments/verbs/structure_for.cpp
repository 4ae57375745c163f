// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/structure_for.h"

#include <algorithm>

#include "experiments/lab/family.h"
#include "structures/registry.h"

namespace kinex::verbs {

namespace {

bool is_about(const StructureInfo& info, const Scene& scene) {
  if (scene.has_lines()) return info.lines != LineUse::kNone;
  if (!scene.objects.front().ends.empty()) return info.graph;
  return scene.extents != Extents::kNone && info.usual_extents() == scene.extents;
}

bool names_colours(const Request& request) {
  return request.of.kind == Subset::Kind::kColours || !request.colours.empty() ||
         std::any_of(request.over.begin(), request.over.end(), names_colours);
}

}  // namespace

std::string structure_for(const Scene& scene) {
  if (!scene.objects.empty()) {
    for (const StructureInfo& info : structure_infos()) {
      if (is_about(info, scene) && !refusal_of(info, scene)) return std::string(info.name);
    }
  }
  return lab::usual_structure(scene.has_bodies(), scene.dimension);
}

bool ignores_colours(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const SceneObject& object) { return !object.colour.empty(); }) &&
         std::none_of(scene.maintain.begin(), scene.maintain.end(), names_colours);
}

}  // namespace kinex::verbs
