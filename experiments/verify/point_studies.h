// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of structures for points that are not runs of one structure on the scenes of a cell.
#ifndef KINEX_EXPERIMENTS_VERIFY_POINT_STUDIES_H
#define KINEX_EXPERIMENTS_VERIFY_POINT_STUDIES_H

#include <functional>

#include "experiments/verify/judge.h"

namespace kinex {

// hanger_expectation.cpp. Events of the kinetic hanger over many seeds of its coins, against their
// exact expectation.
StudyResult study_hanger(bool quick, const std::function<bool()>& go_on);

// hull_locality.cpp. Certificates per point of the kinetic hull, with slope certificates and
// without.
StudyResult study_hull_locality(bool quick, const std::function<bool()>& go_on);

}  // namespace kinex

#endif
