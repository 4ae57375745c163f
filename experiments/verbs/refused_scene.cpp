// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/refused_scene.h"

#include <cstddef>

#include "core/engine/refused_change.h"
#include "core/numbers/show_text.h"

namespace kinex::verbs {

namespace {

// The JSON path of the flight plan of the object that begins at t; empty if none does.
std::string plan_at(const Scene& scene, std::size_t object, const Rational& t) {
  const auto& pieces = scene.objects[object].motion.pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].from || *pieces[i].from != t) continue;
    return "/objects/" + std::to_string(object) + "/motion/" + std::to_string(i);
  }
  return "";
}

}  // namespace

formats::InputError refused_scene(const Scene& scene, const std::string& file,
                                  const std::invalid_argument& refusal) {
  const std::string problem = refusal.what();
  std::string place;
  if (const auto* change = dynamic_cast<const RefusedChange*>(&refusal)) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      if (!problem.starts_with(show_text(scene.objects[i].id) + " ")) continue;
      const std::string here = plan_at(scene, i, change->time());
      if (!here.empty() && !place.empty()) return {file, "", problem, ""};
      if (!here.empty()) place = here;
    }
  }
  return {file, place, problem, ""};
}

}  // namespace kinex::verbs
