// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on the extent of point sets (experiments/lab/family.h).
#ifndef KINEX_EXPERIMENTS_FAMILIES_EXTENT_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_EXTENT_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex::families {

lab::FamilyExperiments extent_experiments();

}  // namespace kinex::families

#endif
