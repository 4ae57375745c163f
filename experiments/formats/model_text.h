// SPDX-License-Identifier: GPL-3.0-or-later
// Descriptions of a scene's model and of the structures that a run builds, as text.
#ifndef KINEX_EXPERIMENTS_FORMATS_MODEL_TEXT_H
#define KINEX_EXPERIMENTS_FORMATS_MODEL_TEXT_H

#include <string>

#include "core/engine/simulator.h"
#include "core/motion/scene.h"

namespace kinex::formats {

// The scene's name; "(no name)" if it has none.
std::string shown_name(const Scene& scene);

// The kind of its objects: "points", "points of 2 colours", "balls", "lines and points".
std::string objects_in_words(const Scene& scene);

// The lines "scene", "objects", "motion", "maintain", and "left out": the parts of the program that
// the scene does not need.
std::string describe_model(const Scene& scene, const std::string& hash);

// Details of the model, for a simulator made for the scene (started or not): the number types, the
// degree and number type of each kind of certificate polynomial, the structures that each structure
// reads and shares, the scheduling.
std::string explain_model(const Scene& scene, const Simulator& simulator);

}  // namespace kinex::formats

#endif
