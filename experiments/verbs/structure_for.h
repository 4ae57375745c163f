// SPDX-License-Identifier: GPL-3.0-or-later
// The structure that an imported scene maintains where neither the file nor the user names one.
#ifndef KINEX_EXPERIMENTS_VERBS_STRUCTURE_FOR_H
#define KINEX_EXPERIMENTS_VERBS_STRUCTURE_FOR_H

#include <string>

#include "core/motion/scene.h"

namespace kinex::verbs {

// The first registered structure that is about what the scene's objects are beside points (discs, boxes, points
// with weights, edges of a graph, lines), and can be maintained; the usual one of points and bodies if there is none.
std::string structure_for(const Scene& scene);

// True if an object has a colour, and no structure of the scene is about colours.
bool ignores_colours(const Scene& scene);

}  // namespace kinex::verbs

#endif
