// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on the proximity of points.
#ifndef KINEX_EXPERIMENTS_FAMILIES_PROXIMITY_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_PROXIMITY_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex::families {

lab::FamilyExperiments proximity_experiments();

}  // namespace kinex::families

#endif
