// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates that compare the gaps between two pairs of discs (Scene::extents: radii are the last axis
// of a motion). The gap of a and b is |ab| - r_a - r_b. It is no polynomial; its comparison is a choice
// among conjunctions of polynomial claims. The terms are those of predicates/predicates.h.
#ifndef KINEX_PREDICATES_POINTS_GAP_PREDICATES_H
#define KINEX_PREDICATES_POINTS_GAP_PREDICATES_H

#include <cstdint>
#include <memory>

#include "core/arithmetic/predicate.h"

namespace kinex {

// See make_gap_claim.
enum class GapTerm : std::uint8_t { kRadii, kLeft, kRight, kProduct };

// Claims about four discs (a, b, p, q), with A = |ab|^2, B = |pq|^2, s = r_a + r_b - r_p - r_q, in
// `dimension` axes, 1 to 3. Their names:
//   kRadii    radius_order  s                            degree 1 in coordinates and radii
//   kLeft     gap_left      B + s^2 - A                         2
//   kRight    gap_right     B - s^2 - A                         2
//   kProduct  gap_product   (A - B)^2 - 2 s^2 (A + B) + s^4     4
// `negated`: minus that, under the name radius_order_negated, ..
//   (1) gap(a, b) <= gap(p, q), that is sqrt(A) <= sqrt(B) + s, iff one of these holds:
//         s >= 0, gap_left >= 0     s >= 0, gap_product <= 0     s <= 0, gap_right >= 0, gap_product >= 0
//   (2) radius_order(p, q, a, b) = -radius_order(a, b, p, q)
//   (3) gap_right(p, q, a, b) = -gap_left(a, b, p, q)
//   (4) gap_product(p, q, a, b) = gap_product(a, b, p, q)
//   (5) gap_product = (A - B - s^2)^2 - 4 s^2 B is the product of s + (+-)sqrt(A) + (+-)sqrt(B) over all
//       four choices of signs
std::shared_ptr<const Predicate> make_gap_claim(GapTerm term, bool negated, int dimension);

}  // namespace kinex

#endif
