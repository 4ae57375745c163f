// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on moving points in boxes.
#ifndef KINEX_EXPERIMENTS_FAMILIES_RANGE_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_RANGE_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex::families {

lab::FamilyExperiments range_experiments();

}  // namespace kinex::families

#endif
