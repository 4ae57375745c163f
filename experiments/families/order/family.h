// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on objects in the order of a key.
#ifndef KINEX_EXPERIMENTS_FAMILIES_ORDER_FAMILY_H
#define KINEX_EXPERIMENTS_FAMILIES_ORDER_FAMILY_H

#include "experiments/lab/family.h"

namespace kinex::families {

lab::FamilyExperiments order_experiments();

}  // namespace kinex::families

#endif
