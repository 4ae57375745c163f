// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/convex_hull_2_signs.h"

#include <algorithm>
#include <array>
#include <utility>

#include "predicates/predicates.h"

namespace kinex {

HullSigns::HullSigns(Kernel& kernel)
    : kernel_(&kernel),
      order_{kernel.bind(make_coordinate_order(0)), kernel.bind(make_coordinate_order(1))},
      turn_(kernel.bind(make_orientation_2())),
      slope_(kernel.bind(make_slope_order_2())) {}

// v is left of w if the direction of v is counter-clockwise from that of w: (d - c) x (b - a) for
// w = cd, v = ab. The pairs are ordered so that exchanging v and w exchanges the first two
// arguments: the arithmetic then reuses the polynomial.
Query HullSigns::corners(Half half, Corner v, Corner w) const {
  Corner first = w, second = v;
  if (half == kLower) std::swap(first, second);
  if (std::min(first.a, first.b) < std::min(second.a, second.b)) {
    return Query(slope_, {first.a, first.b, second.a, second.b});
  }
  return Query(slope_, {second.b, second.a, first.a, first.b});
}

bool HullSigns::slopes_hold(ObjectId a, ObjectId b) const {
  for (const PredicateId order : order_) {
    const Sign sign = kernel_->sign_after(order, {a, b});
    if (sign != Sign::kZero) return sign == Sign::kPositive;
    note_tie();
  }
  return b < a;
}

bool HullSigns::equal(ObjectId a, ObjectId b) const {
  return kernel_->sign_after(order_[0], {a, b}) == Sign::kZero &&
         kernel_->sign_after(order_[1], {a, b}) == Sign::kZero;
}

HullSigns::Substitutes HullSigns::slopes_tie(ObjectId a, ObjectId b) const {
  note_tie();
  Substitutes result;
  result.queries[result.count++] = Query(order_[1], {a, b});
  result.holds = b < a;
  return result;
}

bool HullSigns::higher(Half half, ObjectId a, ObjectId b) const {
  const Sign sign = kernel_->sign_after(order_[1], {b, a});
  if (sign == Sign::kZero) return a < b;
  return (sign == Sign::kPositive) == (half == kUpper);
}

// Lifting p by e changes the value by e (x_r - x_q), and so on cyclically.
HullSigns::Substitutes HullSigns::turn_tie(ObjectId p, ObjectId q, ObjectId r) const {
  note_tie();
  Substitutes result;
  std::array<std::array<ObjectId, 3>, 3> lifts{{{p, q, r}, {q, r, p}, {r, p, q}}};
  std::sort(lifts.begin(), lifts.end());
  for (const auto& lift : lifts) {
    for (const PredicateId order : order_) {
      result.queries[result.count++] = Query(order, {lift[1], lift[2]});
    }
  }
  // Three equal points: counter-clockwise from the largest id down.
  result.holds = lifts[0][1] > lifts[0][2];
  return result;
}

bool HullSigns::above(Half half, Corner v, ObjectId c) const {
  Sign sign = kernel_->sign_after(turn_, {v.b, v.a, c});
  if (sign != Sign::kZero) return (sign == Sign::kPositive) == (half == kUpper);
  const Substitutes ties = height_tie(true, v, c);
  for (std::size_t i = 0; i < ties.count; ++i) {
    const Query& query = ties.queries[i];
    sign = kernel_->sign_after(query.predicate, {query.ids[0], query.ids[1]});
    if (sign != Sign::kZero) return sign == Sign::kPositive;
  }
  return ties.holds;
}

bool HullSigns::corners_hold(Half half, Corner v, Corner w) const {
  const Sign sign = kernel_->sign_after(slope_, {w.a, w.b, v.a, v.b});
  if (sign != Sign::kZero) return (sign == Sign::kPositive) == (half == kUpper);
  return corners_tie(v, w);
}

// A corner moves right when b is lifted, and left when a is: the value is the product of the
// difference in x of one corner and the lift of the other's point.
bool HullSigns::corners_tie(Corner v, Corner w) const {
  note_tie();
  const bool v_moves = !equal(w.a, w.b), w_moves = !equal(v.a, v.b);
  struct Lift {
    ObjectId id;
    bool moves, left;
  };
  std::array<Lift, 4> lifts{
      {{v.a, v_moves, false}, {v.b, v_moves, true}, {w.a, w_moves, true}, {w.b, w_moves, false}}};
  std::sort(lifts.begin(), lifts.end(), [](const Lift& x, const Lift& y) { return x.id < y.id; });
  for (const Lift& lift : lifts) {
    if (lift.moves) return lift.left;
  }
  return lifts[0].left;
}

}  // namespace kinex
