// SPDX-License-Identifier: GPL-3.0-or-later
// The failure times of up to four differences of polynomials side by side, in lanes: what an order
// asks for when neighbours change places.
//
//   rows, subtracted --> shifted to the origin --> sign at now --> first node --> root
//      all degrees             2 and 3               2 and 3        2 and 3      1 and 2
//
// Numbers and bounds are those of ExactArithmetic for one query (exact_arithmetic_difference.cpp,
// first_root.h), in the same order of operations: what a lane tells is bit for bit what is found alone.
#ifndef KINEX_CORE_NUMBERS_DIFFERENCE_LANES_H
#define KINEX_CORE_NUMBERS_DIFFERENCE_LANES_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/numbers/ball.h"
#include "core/numbers/first_root.h"
#include "core/numbers/lanes.h"

namespace kinex::filter {
// The largest degree of motions whose differences are taken in lanes.
inline constexpr int kMaxDifferenceDegree = 3;

// The coefficients to subtract, degree + 1 entries each, for every lane. Number: double (the
// differences and their shifts are exact) or Ball.
template <class Number>
struct DifferenceRows {
  std::array<const Number*, kLanes> from, to;
};

struct DifferenceSpan {  // the times of a group
  double shift;           // the rows are in t - (origin - shift)
  double origin;          // roots are sought in t - origin; those of doubles of degree 1 in t
  double now_lo, now_hi;  // an interval around now, in t
  // Bit j: now is a root of the polynomial of lane j, the only one in [now_lo, now_hi], and the polynomial is
  // positive right after it. Of degree 1: now is its root, and it rises.
  std::uint32_t root;
  bool alike;  // the first entries of what follows are those of all lanes, and no other is read
  // The first nodes are [now_hi - origin, end], of this length, rounded up (degrees 2 and 3). No root
  // beyond the horizon is asked for, in t (degree 1).
  std::array<double, kLanes> end, length, horizon;
  double nothing;  // the value of lo and hi of the lanes in which no root is found
};

// Of the results bit j, or entry j, is that of lane j.
struct DifferenceLanes {
  // Certainly positive right after now, or with a root in closed form. Other lanes are in no set below.
  std::uint32_t known;
  std::uint32_t clear;  // known, and no failure up to the end of the node or the horizon
  std::uint32_t found;  // known, and [lo, hi] isolates the first failure, in t
  std::array<double, kLanes> lo, hi;
  // Of degrees 2 and 3: the polynomials (first_root.h), and the coefficients of their first nodes.
  Lanes c[kMaxDifferenceDegree + 1], m[kMaxDifferenceDegree + 1], error;
  Lanes bernstein[kMaxDifferenceDegree + 1];
};

// Requires 1 <= degree <= 3, and a machine with `vectors`.
template <class Number>
void difference_lanes(const DifferenceRows<Number>& rows, int degree, const DifferenceSpan& span,
                      Vectors vectors, DifferenceLanes& out);
extern template void difference_lanes(const DifferenceRows<double>&, int, const DifferenceSpan&,
                                      Vectors, DifferenceLanes&);
extern template void difference_lanes(const DifferenceRows<Ball>&, int, const DifferenceSpan&,
                                      Vectors, DifferenceLanes&);

// FirstRoot::from_first_node for a lane of degree 2 or 3 that is known, and neither clear nor found.
Search from_first_node(const DifferenceLanes& lanes, std::size_t lane, int degree,
                       const DifferenceSpan& span, Enclosure& out);

}  // namespace kinex::filter

#endif
