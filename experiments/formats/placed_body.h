// SPDX-License-Identifier: GPL-3.0-or-later
// Convex polygons at one rational instant: where a body is, whether two are apart, how far. Exact.
#ifndef KINEX_EXPERIMENTS_FORMATS_PLACED_BODY_H
#define KINEX_EXPERIMENTS_FORMATS_PLACED_BODY_H

#include <vector>

#include "core/motion/scene.h"

namespace kinex::formats {

// Vertices of a convex polygon, counter-clockwise.
using Polygon2 = std::vector<Vertex2>;

// The polygon at the position of its body at t. Requires a rotor that is not zero at t.
Polygon2 placed_polygon(const Polygon2& polygon, const Trajectory& trajectory, const Rational& t);

// Polygons are closed sets: they touch if they have common points and their interiors have none.
enum class Contact { kApart, kTouching, kOverlapping };

// By separating lines along all edges: two disjoint convex polygons, or two with disjoint
// interiors, have one. O(n_a + n_b) products, by an antipodal walk; the edge that separates best in
// floating point is tried first.
Contact contact_of(const Polygon2& a, const Polygon2& b);

// The squared distance; 0 if the polygons are not apart. All pairs of a vertex and an edge:
// O(n_a n_b).
Rational squared_distance(const Polygon2& a, const Polygon2& b);

}  // namespace kinex::formats

#endif
