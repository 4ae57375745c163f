// SPDX-License-Identifier: GPL-3.0-or-later
// The generators of scenes that make a sorted list work hardest.
#ifndef KINEX_EXPERIMENTS_FAMILIES_ORDER_WORKLOADS_H
#define KINEX_EXPERIMENTS_FAMILIES_ORDER_WORKLOADS_H

#include "experiments/lab/workload.h"

namespace kinex::families {

// sort_worst.cpp
void generate_sort_worst(const lab::WorkloadParameters&, Scene&);

}  // namespace kinex::families

#endif
