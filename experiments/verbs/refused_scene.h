// SPDX-License-Identifier: GPL-3.0-or-later
// What a run refuses in a scene that its reader takes, with file and place.
#ifndef KINEX_EXPERIMENTS_VERBS_REFUSED_SCENE_H
#define KINEX_EXPERIMENTS_VERBS_REFUSED_SCENE_H

#include <stdexcept>
#include <string>

#include "core/motion/scene.h"
#include "experiments/formats/input_error.h"

namespace kinex::verbs {

// "scene.json: /objects/2/motion/1: c appears at 6 in contact with a; ..": the place is that of the flight plan that
// begins then, if one object alone has one and is named. Of other refusals the file alone is known.
formats::InputError refused_scene(const Scene& scene, const std::string& file,
                                  const std::invalid_argument& refusal);

}  // namespace kinex::verbs

#endif
