// SPDX-License-Identifier: GPL-3.0-or-later
// The exact number of swaps of a scene of lines, found without simulation. It shares no code with
// the structures that it checks.
#ifndef KINEX_EXPERIMENTS_FAMILIES_ORDER_INVERSIONS_H
#define KINEX_EXPERIMENTS_FAMILIES_ORDER_INVERSIONS_H

#include "core/motion/scene.h"
#include "core/numbers/integer.h"

namespace kinex::families {

// The number of pairs of objects that change places on the first axis: inversions between the order
// right after the start and the order right after the end (in a scene without end: at infinity).
// Objects that move together keep their order. Requires linear motion in one piece. O(n log n).
Integer inversions(const Scene& scene);

}  // namespace kinex::families

#endif
