// SPDX-License-Identifier: GPL-3.0-or-later
// The exact number of changes of a maximum of lines, found without simulation. It shares no code
// with the structures that it checks.
#ifndef KINEX_EXPERIMENTS_FAMILIES_MAXIMUM_ENVELOPE_WITNESS_H
#define KINEX_EXPERIMENTS_FAMILIES_MAXIMUM_ENVELOPE_WITNESS_H

#include "core/motion/scene.h"
#include "core/numbers/integer.h"

namespace kinex::families {

// How often the largest (smallest) first coordinate passes to another object: breakpoints of the
// upper (lower) envelope in (start, end]. Requires linear motion in one piece. O(n log n).
// Ties: of several objects that are on the envelope at one point only the last one counts.
Integer upper_envelope_changes(const Scene& scene);
Integer lower_envelope_changes(const Scene& scene);

}  // namespace kinex::families

#endif
