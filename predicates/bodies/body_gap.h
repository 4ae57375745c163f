// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps between bounding volumes of two bodies, for any orientation of the bodies. A body's first
// two axes are the position of its frame's origin. `reach` is a constant object of one axis: the
// sum, over both bodies, of the distance of the farthest point from the origin (or a signed sum,
// for single ends of intervals). d is the degree of the positions.
#ifndef KINEX_PREDICATES_BODIES_BODY_GAP_H
#define KINEX_PREDICATES_BODIES_BODY_GAP_H

#include <memory>

#include "core/arithmetic/predicate.h"

namespace kinex {

// discs_apart(a, b, reach) = |b - a|^2 - reach^2. Positive iff the discs are disjoint. Degree 2 in
// the lengths, 2d in t. `negated`: the negated value, named discs_overlap.
//   (1) discs_apart(b, a, reach) = discs_apart(a, b, reach)
//   (2) discs_apart(a, b, -reach) = discs_apart(a, b, reach)
//   (3) discs_overlap = -discs_apart
std::shared_ptr<const Predicate> make_discs_apart(bool negated);

// axis_gap(a, b, reach) = b - a - reach on `axis` (0 or 1; named x_gap, y_gap). Positive iff the
// intervals have a gap, a before b. Degree 1 in the lengths, d in t.
//   (1) axis_gap(b, a, -reach) = -axis_gap(a, b, reach)
std::shared_ptr<const Predicate> make_axis_gap(int axis);

// beyond_line(a, line) = a - line on `axis`, `line` a constant object of one axis (named x_beyond,
// y_beyond). Positive iff a is beyond the line. Degree 1 in the lengths, d in t. `negated`: the
// negated value, line - a, named x_short_of, y_short_of.
//   (1) x_short_of = -x_beyond, y_short_of = -y_beyond
std::shared_ptr<const Predicate> make_beyond_line(int axis, bool negated);

}  // namespace kinex

#endif
