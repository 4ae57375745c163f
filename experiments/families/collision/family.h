// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on collisions of rigid polygons.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex::families {

lab::FamilyExperiments collision_experiments();

}  // namespace kinex::families

#endif
