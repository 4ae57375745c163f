// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes with one object near to all others, on which the report doubts, or denies, that a structure is
// local. They are made for studies; `kinex gen` has no name for them.
#ifndef KINEX_EXPERIMENTS_FAMILIES_PROXIMITY_HUB_SCENES_H
#define KINEX_EXPERIMENTS_FAMILIES_PROXIMITY_HUB_SCENES_H

#include "core/motion/scene.h"

namespace kinex::families {

// A point at rest, and n - 1 in a ring about it, at distances near 1 that change: from most of them it
// is the next one in one of their cones.
Scene hub_of_points(int n);
// A disc of radius 1 at rest, and n - 1 small ones, which never meet, beside its rim. Their gaps to the
// large one change, and all are smaller than those between small ones.
Scene hub_of_discs(int n);

}  // namespace kinex::families

#endif
