// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a scene of bodies by an angle, so that structures that favour the axes have no advantage.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_TURNED_SCENE_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_TURNED_SCENE_H

#include "core/motion/scene.h"
#include "experiments/lab/scene_change.h"

namespace kinex::families {

// Turns polygons and paths about the origin by the k-th angle of a sequence in (0, 90) degrees
// whose beginnings are all well spread. Exact. Rotors stay the same, since turns commute. Requires
// a scene of bodies.
void turn_scene(Scene& scene, int k);

inline constexpr lab::SceneChange kTurned{"turned", turn_scene};

}  // namespace kinex::families

#endif
