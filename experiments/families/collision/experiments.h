// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on structures for collisions; each source file states its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_EXPERIMENTS_H

#include <functional>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/cell.h"
#include "experiments/lab/judge.h"
#include "structures/parts/descriptor.h"

namespace kinex::families {

// cells.cpp. All methods on the same scenes.
void add_collision_cells(lab::Catalogue& catalogue, lab::Extent extent);
// common_cells.cpp. Hard bounds and audits of one structure on every kind of scene of bodies.
void add_common_body_cells(lab::Catalogue& catalogue, const StructureInfo& structure, lab::Extent extent);

// outer_hierarchies.cpp. Do the outer hierarchies of a polygon keep their bounds on depth and on
// the number of nodes at a distance? Every policy of cuts on round, random, thin and exponentially
// uneven polygons.
lab::StudyResult study_outer_hierarchies(bool quick, const std::function<bool()>& go_on);

// contact_agreement.cpp. Do all methods report a contact at the same instant, that of the witness
// (contact_witness.h)? Random pairs of polygons, with and without turning.
lab::StudyResult study_contacts(bool quick, const std::function<bool()>& go_on);

// wedge_cover.cpp. Does separation_hysteresis have at most as many events as balls cover the motion
// (ball_cover.h)? Trembling, kinks, an approach, and turning, with either body as the first.
lab::StudyResult study_wedge_cover(bool quick, const std::function<bool()>& go_on);

// tangent_fans.cpp. How often does each of the two inner tangents change while a polygon turns in
// front of a fan?
lab::StudyResult study_tangents(bool quick, const std::function<bool()>& go_on);
// bench_rows.cpp
std::vector<lab::BenchRow> collision_bench_rows(int scale);

}  // namespace kinex::families

#endif
