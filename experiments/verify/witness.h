// SPDX-License-Identifier: GPL-3.0-or-later
// Exact event counts of a scene of lines, found without simulation. They share no code with the
// structures that they check.
#ifndef KINEX_EXPERIMENTS_VERIFY_WITNESS_H
#define KINEX_EXPERIMENTS_VERIFY_WITNESS_H

#include "core/motion/scene.h"
#include "core/numbers/integer.h"

namespace kinex {

// The number of pairs of objects that change places on the first axis: inversions between the order
// right after the start and the order right after the end (in a scene without end: at infinity).
// Objects that move together keep their order. Requires linear motion in one piece. O(n log n).
Integer inversions(const Scene& scene);

// How often the largest (smallest) first coordinate passes to another object: breakpoints of the
// upper (lower) envelope in (start, end]. Requires linear motion in one piece. O(n log n).
// Ties: of several objects that are at the envelope in one point only the last one counts.
Integer upper_envelope_changes(const Scene& scene);
Integer lower_envelope_changes(const Scene& scene);

}  // namespace kinex

#endif
