// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of points for the structures of all families, and the common checks of all of them
// (experiments/lab/family.h).
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex::families {

lab::FamilyExperiments point_experiments();

}  // namespace kinex::families

#endif
