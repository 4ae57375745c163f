// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of points for the structures of all families, and what is asked of all of them.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex {

FamilyExperiments point_experiments();

}  // namespace kinex

#endif
