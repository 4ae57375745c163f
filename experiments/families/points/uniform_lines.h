// SPDX-License-Identifier: GPL-3.0-or-later
// Expected event counts for lines whose values at t = 0 and at t = 1 are independent and uniform in
// [0, 1], on 0 < t < 1.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_UNIFORM_LINES_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_UNIFORM_LINES_H

namespace kinex::families {

// Expected number of changes of the maximum of m lines; relative error below 1e-9. 0 for m < 2.
//
// Derivation. A line is at y with slope v at time t with density 1 as long as y - tv and y + (1-t)v
// are in [0, 1], that is for v in an interval of length g(t, y), the density of the position. Two
// lines cross at (t, y) at the rate of the integral of |v - w| over v and w in that interval,
// g^3/3, and the crossing is on the upper envelope if the m - 2 others are below, F^(m-2) with F
// the distribution function of the position. So the expectation is C(m,2) times the integral over t
// and y of F^(m-2) g^3 / 3. The position is a sum of two uniform numbers, and g is a trapezoid. The
// integral over y is evaluated in closed form on its three parts, that over t by Gauss-Legendre.
double expected_envelope_changes(int m);

// Expected number of failures of a kinetic tournament of n = 2^k lines. A failure of a node with m
// leaves is a change of their envelope between two lines of different children, and each pair of
// lines is equally likely to be the one that changes: m / (2 (m - 1)) of the changes.
double expected_tournament_failures(int n);

}  // namespace kinex::families

#endif
