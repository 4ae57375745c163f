// SPDX-License-Identifier: GPL-3.0-or-later
// The generators of scenes of points that are for every structure.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_WORKLOADS_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_WORKLOADS_H

#include <vector>

#include "experiments/lab/workload.h"

namespace kinex::families {

// All of them, in the order in which users see them.
std::vector<lab::Workload> point_workloads();

// uniform.cpp: origin and destination at random, t in [0, 1]
void generate_uniform_square(const lab::WorkloadParameters&, Scene&);
void generate_uniform_disk(const lab::WorkloadParameters&, Scene&);
void generate_gaussian(const lab::WorkloadParameters&, Scene&);
// lattices.cpp
void generate_grid(const lab::WorkloadParameters&, Scene&);
void generate_lattice(const lab::WorkloadParameters&, Scene&);
// meetings.cpp: degenerate at t = 1/2, or nearly so
void generate_meet(const lab::WorkloadParameters&, Scene&);
void generate_through_one_point(const lab::WorkloadParameters&, Scene&);
void generate_near_one_point(const lab::WorkloadParameters&, Scene&);
void generate_collinear_instant(const lab::WorkloadParameters&, Scene&);
// circles.cpp: degenerate at all times
void generate_counter_rotating_rings(const lab::WorkloadParameters&, Scene&);
void generate_expanding_circle(const lab::WorkloadParameters&, Scene&);
void generate_rotating_circle(const lab::WorkloadParameters&, Scene&);
// static_one_mover.cpp
void generate_static_one_mover(const lab::WorkloadParameters&, Scene&);
// changes.cpp: flight plans that change, objects that come and go
void generate_new_plans(const lab::WorkloadParameters&, Scene&);
void generate_come_and_go(const lab::WorkloadParameters&, Scene&);
// walks.cpp: a new flight plan at every fix
void generate_walks(const lab::WorkloadParameters&, Scene&);

}  // namespace kinex::families

#endif
