// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of collision detection that are not runs of one structure.
#ifndef KINEX_EXPERIMENTS_VERIFY_COLLISION_STUDIES_H
#define KINEX_EXPERIMENTS_VERIFY_COLLISION_STUDIES_H

#include <functional>

#include "experiments/verify/judge.h"

namespace kinex {

// outer_hierarchies.cpp. Do the outer hierarchies of a polygon keep their bounds on depth and on
// the number of nodes at a distance? Every policy of cuts on round, random, thin and exponentially
// uneven polygons.
StudyResult study_outer_hierarchies(bool quick, const std::function<bool()>& go_on);

// contact_agreement.cpp. Do all methods report a contact at the same instant, that of the witness
// (collision_witness.h)? Random pairs of polygons, with and without turning.
StudyResult study_contacts(bool quick, const std::function<bool()>& go_on);

// wedge_cover.cpp. Does separation_hysteresis have at most as many events as balls cover the motion
// (ball_cover.h)? Trembling, kinks, an approach, and turning, with either body as the first.
StudyResult study_wedge_cover(bool quick, const std::function<bool()>& go_on);

// tangent_fans.cpp. How often does each of the two inner tangents change while a polygon turns
// before a fan?
StudyResult study_tangents(bool quick, const std::function<bool()>& go_on);

}  // namespace kinex

#endif
