// SPDX-License-Identifier: GPL-3.0-or-later
// Hard bounds that hold for the extremum of functions of time, whatever maintains it.
#ifndef KINEX_STRUCTURES_PARTS_EXTREMUM_BOUNDS_H
#define KINEX_STRUCTURES_PARTS_EXTREMUM_BOUNDS_H

#include <vector>

#include "core/engine/bound.h"
#include "core/numbers/integer.h"

namespace kinex {

// How often the extremum of one function per object can change in a run; 0 without objects.
//
//   without flight-plan changes   lambda_D(n) - 1
//   with them                     each piece of a motion is a function on an interval:
//                                 lambda_{D+2}(pieces) - 1, or one change per crossing of two of
//                                 them, whichever is less
//   ties resolved                 one more each: the ledger's events of the kind "tie"
//
// `pieces`: of the functions' objects. `common`: pieces of one more motion that all functions
// depend on. `degree`: D, of the difference of two functions.
// Source: Davenport-Schinzel sequences; Guibas, "Kinetic data structures" (1998), section 5.
Integer extremum_changes(const BoundContext& context, const std::vector<int>& pieces, int common,
                         int degree);

}  // namespace kinex

#endif
