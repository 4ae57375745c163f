// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on maxima and minima of a key.
#ifndef KINEX_EXPERIMENTS_FAMILIES_MAXIMUM_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_MAXIMUM_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex::families {

lab::FamilyExperiments maximum_experiments();

}  // namespace kinex::families

#endif
