// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps between bounding volumes of two bodies, whatever way they are turned. A body's first two
// axes are the position of its frame's origin; `reach` is a constant object of one axis, the sum of
// the distances of their farthest points from those origins (or a signed sum, for single ends of
// intervals).
#ifndef KINEX_PREDICATES_BODY_GAP_H
#define KINEX_PREDICATES_BODY_GAP_H

#include <memory>

#include "core/predicate.h"

namespace kinex {

// discs_apart(a, b, reach) = |b - a|^2 - reach^2. `negated`: the negated value (named
// discs_overlap). Degree 2d for positions of degree d.
std::shared_ptr<const Predicate> make_discs_apart(bool negated);

// axis_gap(a, b, reach) = b - a - reach on `axis` (0 or 1; named x_gap, y_gap). Degree d.
std::shared_ptr<const Predicate> make_axis_gap(int axis);

// beyond_line(a, line) = a - line on `axis`, `line` a constant object of one axis (named x_beyond,
// y_beyond). `negated`: line - a (x_short_of, y_short_of). Degree d.
std::shared_ptr<const Predicate> make_beyond_line(int axis, bool negated);

}  // namespace kinex

#endif
