// SPDX-License-Identifier: GPL-3.0-or-later
// A scene of bodies turned to another direction, so that structures that favour the axes gain
// nothing.
#ifndef KINEX_EXPERIMENTS_LAB_TURNED_SCENE_H
#define KINEX_EXPERIMENTS_LAB_TURNED_SCENE_H

#include "core/motion/scene.h"

namespace kinex {

// Turns polygons and paths about the origin by the k-th of many angles between 0 and 90 degrees,
// well spread for every number of them; exactly. Rotors stay, for turns commute. Bodies only.
void turn_scene(Scene& scene, int k);

}  // namespace kinex

#endif
