// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene is made of and what a run of it builds, in lines for people.
#ifndef KINEX_EXPERIMENTS_MODEL_TEXT_H
#define KINEX_EXPERIMENTS_MODEL_TEXT_H

#include <string>

#include "core/scene.h"
#include "core/simulator.h"

namespace kinex {

// "scene", "objects", "motion", "maintain" lines, then "left out": what the scene does not need.
std::string describe_model(const Scene& scene, const std::string& hash);

// More of the model, for a simulator made for the scene (started or not): the number types, the
// degree of each kind of certificate polynomial and what it is computed in, what each structure
// reads and who shares it, the scheduling.
std::string explain_model(const Scene& scene, const Simulator& simulator);

}  // namespace kinex

#endif
