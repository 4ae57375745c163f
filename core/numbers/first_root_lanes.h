// SPDX-License-Identifier: GPL-3.0-or-later
// The first step of the filter for failure times (core/numbers/first_root.h) for four polynomials side by
// side: their signs over an interval, and the Bernstein coefficients of their first nodes.
//
// Most certificates that are renewed do not fail soon: they are answered here. Of the others FirstRoot
// continues from the coefficients. Every number is bit for bit that of the filter for one polynomial.
#ifndef KINEX_CORE_NUMBERS_FIRST_ROOT_LANES_H
#define KINEX_CORE_NUMBERS_FIRST_ROOT_LANES_H

#include "core/numbers/first_root.h"
#include "core/numbers/lanes.h"

namespace kinex::filter {

// The degrees of in_circle_2 for motions of degree 1, 2 and 3.
inline constexpr int kMaxLaneDegree = 12;
constexpr bool has_lanes(int degree) { return degree == 4 || degree == 8 || degree == 12; }

// Where the polynomials are looked at, in times t - origin. The nodes begin at the end of the interval.
struct LaneSpan {
  double lo, hi;  // an interval
  double width;   // hi - lo, computed before the origin was subtracted
  Lanes length;   // of the nodes
};

struct LaneNodes {  // the first nodes of four polynomials
  // Certainly positive on the interval and of full degree, and the node's coefficients have an error
  // bound.
  LaneMask positive;
  // Moreover positive on the node: no sign change.
  LaneMask clear;
  Lanes error;  // of the coefficients
  Lanes bernstein[kMaxLaneDegree + 1];
};

// c, m: degree + 1 entries, as in first_root.h. Requires has_lanes(degree), |lo|, |hi| <=
// kLeastTimeLimit, and a machine with `vectors`.
void first_nodes(const Lanes* c, const Lanes* m, int degree, const LaneSpan& span, Vectors vectors,
                 LaneNodes& out);

// FirstRoot on (a, b] for one lane of positive ones, from its first node [a, end].
Search from_first_node(const LaneNodes& nodes, std::size_t lane, const Lanes* c, const Lanes* m,
                       int degree, double origin, double a, double end, Enclosure& out);

}  // namespace kinex::filter

#endif
