// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on convex hulls.
#ifndef KINEX_EXPERIMENTS_FAMILIES_HULL_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_HULL_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex::families {

lab::FamilyExperiments hull_experiments();

}  // namespace kinex::families

#endif
