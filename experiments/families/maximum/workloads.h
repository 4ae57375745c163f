// SPDX-License-Identifier: GPL-3.0-or-later
// The generators of scenes that make structures for a maximum work hardest.
#ifndef KINEX_EXPERIMENTS_FAMILIES_MAXIMUM_WORKLOADS_H
#define KINEX_EXPERIMENTS_FAMILIES_MAXIMUM_WORKLOADS_H

#include "experiments/lab/workload.h"

namespace kinex::families {

// worst_scenes.cpp
void generate_tournament_worst(const lab::WorkloadParameters&, Scene&);
void generate_heap_worst(const lab::WorkloadParameters&, Scene&);

}  // namespace kinex::families

#endif
