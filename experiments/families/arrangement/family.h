// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on moving lines.
#ifndef KINEX_EXPERIMENTS_FAMILIES_ARRANGEMENT_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_ARRANGEMENT_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex::families {

lab::FamilyExperiments arrangement_experiments();  // the descriptor

}  // namespace kinex::families

#endif
