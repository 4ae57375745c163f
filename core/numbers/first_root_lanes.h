// SPDX-License-Identifier: GPL-3.0-or-later
// The first step of the filter for failure times (core/numbers/first_root.h), for four polynomials
// side by side: their signs over an interval, and the Bernstein coefficients of their first nodes.
//
// Most renewed certificates do not fail soon, and this step shows it. For the others FirstRoot
// continues from the coefficients. Every number is bit for bit that of the filter for one
// polynomial.
#ifndef KINEX_CORE_NUMBERS_FIRST_ROOT_LANES_H
#define KINEX_CORE_NUMBERS_FIRST_ROOT_LANES_H

#include "core/numbers/first_root.h"
#include "core/numbers/lanes.h"

namespace kinex::filter {

// The degrees that have lanes: those of in_circle_2 for motions of degree 1, 2 and 3.
inline constexpr int kMaxLaneDegree = 12;
constexpr bool has_lanes(int degree) { return degree == 4 || degree == 8 || degree == 12; }

// The times at which the polynomials are examined, relative to the origin (t - origin): an interval
// around now, and the first nodes, [hi, hi + length].
struct LaneSpan {
  double lo, hi;  // the interval
  double width;   // hi - lo, computed before the origin was subtracted
  Lanes length;   // of the nodes, one per polynomial
};

struct LaneNodes {  // the first nodes of four polynomials
  // The polynomial is certainly positive on the interval, has full degree, and `error` is valid.
  LaneMask positive;
  // As `positive`, and certainly positive on the node too: it has no sign change there.
  LaneMask clear;
  Lanes error;  // of the coefficients
  Lanes bernstein[kMaxLaneDegree + 1];
};

// c, m: degree + 1 entries, as in first_root.h. Requires has_lanes(degree), |lo|, |hi| <=
// kLeastTimeLimit, and a machine with `vectors`.
void first_nodes(const Lanes* c, const Lanes* m, int degree, const LaneSpan& span, Vectors vectors,
                 LaneNodes& out);

// FirstRoot::from_first_node for one lane, which must be `positive`; its first node is [a, end].
Search from_first_node(const LaneNodes& nodes, std::size_t lane, const Lanes* c, const Lanes* m,
                       int degree, double origin, double a, double end, Enclosure& out);

}  // namespace kinex::filter

#endif
