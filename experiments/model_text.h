// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene is made of and what a run of it builds, in lines for people.
#ifndef KINEX_EXPERIMENTS_MODEL_TEXT_H
#define KINEX_EXPERIMENTS_MODEL_TEXT_H

#include <string>

#include "core/scene.h"

namespace kinex {

// "scene", "objects", "motion", "maintain" lines, then "left out": what the scene does not need.
std::string describe_model(const Scene& scene, const std::string& hash);

}  // namespace kinex

#endif
