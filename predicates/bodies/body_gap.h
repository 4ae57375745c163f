// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps between bounding volumes of two bodies, for any orientation of the bodies. A body's first
// two axes are the position of its frame's origin. `reach` is a constant object of one axis: the
// sum of the distances of their farthest points from those origins (or a signed sum, for single
// ends of intervals). d is the degree of the positions.
#ifndef KINEX_PREDICATES_BODIES_BODY_GAP_H
#define KINEX_PREDICATES_BODIES_BODY_GAP_H

#include <memory>

#include "core/arithmetic/predicate.h"

namespace kinex {

// discs_apart(a, b, reach) = |b - a|^2 - reach^2.
//   (1) positive iff the discs are disjoint   (2) degree 2 in the lengths, 2d in t
//   (3) exchanging a and b keeps the value; `negated`: the negated value (named discs_overlap)
std::shared_ptr<const Predicate> make_discs_apart(bool negated);

// axis_gap(a, b, reach) = b - a - reach on `axis` (0 or 1; named x_gap, y_gap).
//   (1) positive iff the intervals have a gap, a before b   (2) degree 1 in the lengths, d in t
//   (3) axis_gap(b, a, -reach) = -axis_gap(a, b, reach)
std::shared_ptr<const Predicate> make_axis_gap(int axis);

// beyond_line(a, line) = a - line on `axis`, `line` a constant object of one axis (named x_beyond,
// y_beyond).
//   (1) positive iff a is beyond the line   (2) degree 1 in the lengths, d in t
//   (3) `negated`: line - a (named x_short_of, y_short_of)
std::shared_ptr<const Predicate> make_beyond_line(int axis, bool negated);

}  // namespace kinex

#endif
