// SPDX-License-Identifier: GPL-3.0-or-later
// The generators of scenes that make structures for a hull work hardest.
#ifndef KINEX_EXPERIMENTS_FAMILIES_HULL_WORKLOADS_H
#define KINEX_EXPERIMENTS_FAMILIES_HULL_WORKLOADS_H

#include "experiments/lab/workload.h"

namespace kinex::families {

// hull_worst.cpp
void generate_hull_worst(const lab::WorkloadParameters&, Scene&);

}  // namespace kinex::families

#endif
