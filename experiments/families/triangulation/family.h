// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on triangulations.
#ifndef KINEX_EXPERIMENTS_FAMILIES_TRIANGULATION_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_TRIANGULATION_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex::families {

lab::FamilyExperiments triangulation_experiments();

}  // namespace kinex::families

#endif
