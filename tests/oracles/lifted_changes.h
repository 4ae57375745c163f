// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of Delaunay and regular triangulations, counted without a triangulation.
#ifndef KINEX_TESTS_ORACLES_LIFTED_CHANGES_H
#define KINEX_TESTS_ORACLES_LIFTED_CHANGES_H

#include <cstdint>

namespace oracles {

// How often the triangulation of n points changes for t from 0 to 1: flips, points that show or hide,
// vertices that enter or leave the hull, flips of its facets. `dimension`: 2 or 3. Origin and destination
// are uniform in the unit square (cube); weights, if there are any, go from one to another number, both
// uniform in [0, n^(-2/dimension)].
// O(n^(dimension + 2)) polynomials; doubles.
std::uint64_t lifted_changes(int dimension, bool weighted, int n, std::uint64_t seed);

}  // namespace oracles

#endif
