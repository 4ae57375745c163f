// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes whose sides have constant directions, by the objects that touch their sides.
#ifndef KINEX_PREDICATES_POINTS_BOX_ORDER_H
#define KINEX_PREDICATES_POINTS_BOX_ORDER_H

#include <cstdint>
#include <memory>

#include "core/arithmetic/predicate.h"
#include "predicates/points/unit_directions.h"

namespace kinex {

// What boxes are compared by: the area, or half the perimeter.
enum class BoxMeasure : std::uint8_t { kArea, kPerimeter };
// A box with a side along u is touched by the objects (r, l, t, b): the farthest along u and against
// u, along u turned by 90 degrees and against that. With the extents W = u.(r - l) and
// H = (u turned).(t - b) its size is H W or H + W, for unit vectors.
//
// box_order(first, second), of two such boxes along u and v, is size(second) - size(first) for
// kFirst, and the negation for kSecond (which box is claimed to be no larger): named
// order_box_area and order_box_perimeter. Over 8 objects, degree 2 and 1 in the coordinates. u and v
// are unit vectors of the plane; both are multiplied by one positive integer.
//   (1) box_order(second, first) of v and u is -box_order(first, second) of u and v
//   (2) kSecond is the negation of kFirst
//   (3) zero for one box twice
enum class SmallerBox : std::uint8_t { kFirst, kSecond };
// See SmallerBox.
std::shared_ptr<const Predicate> make_box_order(BoxMeasure measure, const DirectionVector& u,
                                                const DirectionVector& v, SmallerBox smaller);

}  // namespace kinex

#endif
