// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates that compare the distances of two pairs of a line y = a x + b and a point. The terms are those
// of predicates/predicates.h and predicates/points/line_predicates.h.
#ifndef KINEX_PREDICATES_POINTS_LINE_DISTANCE_ORDER_H
#define KINEX_PREDICATES_POINTS_LINE_DISTANCE_ORDER_H

#include <cstdint>
#include <memory>

#include "core/arithmetic/predicate.h"

namespace kinex {

// How far a point is from a line: straight up or down, or at a right angle.
enum class LineMeasure : std::uint8_t { kHeight, kDistance };

// For lines l, m and points p, q: p is no farther from l than q is from m. With
// h(l, p) = y_p - a_l x_p - b_l, by value:
//   kHeight    order_line_height    h(m, q)^2 - h(l, p)^2                              degree 4
//   kDistance  order_line_distance  h(m, q)^2 (1 + a_l^2) - h(l, p)^2 (1 + a_m^2)      degree 6
//   (1) exchanging (l, p) and (m, q) changes the sign
//   (2) for l = m both have the same sign
std::shared_ptr<const Predicate> make_line_distance_order(LineMeasure measure);

}  // namespace kinex

#endif
