// SPDX-License-Identifier: GPL-3.0-or-later
// HullSigns: the predicates of a kinetic hull, in the dual, with ties resolved.
//
// Point (p, q) is the line y = p x + q: the upper hull is the upper envelope of the lines. The
// lower hull is the same for (p, -q): every predicate names its half.
//
// Ties. Identically zero signs are resolved by a symbolic perturbation:
//   1. all points are sheared, x + delta y, so that points of one x are in the order of y;
//   2. each point is lifted (in its half's sense of up) by an amount that falls fast with its id;
//   3. identically equal points are placed, from the largest id to the smallest, on a tiny arc that
//      opens upwards.
// So no sign is ever zero, and all signs are those of one configuration: the smallest of equal ids
// is the highest, and structures need no special cases. What a tie hides (points on hull edges,
// equal points) is left out when the hull is read.
//
// A certificate whose polynomial is identically zero is replaced by one that fails when the tie is
// resolved differently (the order of two coordinates), or, if that is identically zero too, by
// none.
#ifndef KINEX_STRUCTURES_HULL_CONVEX_HULL_2_SIGNS_H
#define KINEX_STRUCTURES_HULL_CONVEX_HULL_2_SIGNS_H

#include <cstddef>
#include <vector>

#include "core/engine/kernel.h"

namespace kinex {

class HullSigns {
 public:
  enum Half : unsigned { kUpper, kLower };
  // A vertex of an envelope: where line b follows line a.
  struct Corner {
    ObjectId a, b;
  };

  explicit HullSigns(Kernel& kernel);

  // The claims of certificates (>= 0), ties not resolved; motions of degree d.
  //   (1) slopes: degree d; exchanging a and b negates it
  //   (2) height: degree 2d; exchanging v.a and v.b, or `above`, or the half, negates it
  //   (3) corners: degree 2d; exchanging v and w, or the half, negates it
  // Line a has a smaller slope than line b: point a is left of point b.
  Query slopes(ObjectId a, ObjectId b) const { return Query(order_[0], {a, b}); }
  // The corner is above (or below) line c.
  Query height(Half half, bool above, Corner v, ObjectId c) const {
    return above == (half == kUpper) ? Query(turn_, {v.b, v.a, c}) : Query(turn_, {v.a, v.b, c});
  }
  // Corner v is left of corner w.
  Query corners(Half half, Corner v, Corner w) const;

  // The same, just after now, with ties resolved.
  bool slopes_hold(ObjectId a, ObjectId b) const;
  bool above(Half half, Corner v, ObjectId c) const;
  bool corners_hold(Half half, Corner v, Corner w) const;
  // Line a is above line b at the place where they are parallel.
  bool higher(Half half, ObjectId a, ObjectId b) const;

  // Ties not resolved.
  Sign turn(ObjectId a, ObjectId b, ObjectId c) const {
    return kernel_->sign_after(turn_, {a, b, c});
  }
  Query left_turn(ObjectId a, ObjectId b, ObjectId c) const { return Query(turn_, {a, b, c}); }
  Sign order_sign(int axis, ObjectId a, ObjectId b) const {
    return kernel_->sign_after(order_[axis], {a, b});
  }
  Query order(int axis, ObjectId a, ObjectId b) const { return Query(order_[axis], {a, b}); }
  bool equal(ObjectId a, ObjectId b) const;
  // Identically on one line.
  bool collinear(ObjectId a, ObjectId b, ObjectId c) const { return turn(a, b, c) == Sign::kZero; }

  // For a claim whose polynomial is identically zero: the certificates to try in its place, best
  // first; the first that is not identically zero keeps the tie. `holds`: the claim, if all are.
  struct Substitutes {
    Query queries[6];
    std::size_t count = 0;
    bool holds = false;
  };
  Substitutes slopes_tie(ObjectId a, ObjectId b) const;
  Substitutes height_tie(bool above, Corner v, ObjectId c) const {
    return above ? turn_tie(v.b, v.a, c) : turn_tie(v.a, v.b, c);
  }
  bool corners_tie(Corner v, Corner w) const;

  // A sign was identically zero: hulls may hold points that are not strict vertices.
  bool tied() const { return tied_; }
  void note_tie() const { tied_ = true; }

 private:
  // Resolves the sign of "p, q, r turn left", with up as upwards.
  Substitutes turn_tie(ObjectId p, ObjectId q, ObjectId r) const;

  Kernel* kernel_;
  PredicateId order_[2];
  PredicateId turn_;
  PredicateId slope_;
  mutable bool tied_ = false;
};

}  // namespace kinex

#endif
