// SPDX-License-Identifier: GPL-3.0-or-later
// TurnedOrder: the claims of a list of points of the plane along a direction, with the order right
// after an infinitesimal turn where points are level.
//
//   direction  first key    of level points        the last resort
//   (u, v)     u x + v y    v x - u y              the smaller id
//
//   (1, 0)     x            -y
//   (0, 1)     y            x
//   (1, 1)     x + y        x - y
//   (1, -1)    x - y        -(x + y)
//
// Together such orders are those of points without two level ones, however the points are: turned
// counter-clockwise by an infinitesimal angle, and moved by their ids along (2, 1), still less. So
// every boundary ray of a cone around a point belongs to the cone on its counter-clockwise side, and
// all points equal to the point with a larger id to the cone that (2, 1) is in; every other point is
// in one cone of p, and p is in the opposite one of it.
//
// A pair that is identically level by its first key may cease to be level after a new motion: renew
// the certificates of moved points (KineticList::renew).
#ifndef KINEX_STRUCTURES_PROXIMITY_TURNED_ORDER_H
#define KINEX_STRUCTURES_PROXIMITY_TURNED_ORDER_H

#include <array>

#include "structures/parts/claim.h"

namespace kinex {

// The order along a direction whose first entry that is not zero is positive.
PredicateId bind_order_along(Kernel& kernel, const std::array<int, 2>& direction);

class TurnedOrder {
 public:
  // Requires a direction (u, v) with 2 u + v > 0: equal points are in the order of their ids, as if
  // moved by their ids along (2, 1).
  TurnedOrder(Kernel& kernel, const std::array<int, 2>& direction);

  // By the second key if the two are identically level by the first.
  Query claim(Item a, Item b) const;
  bool goes_first(Item a, Item b) const { return a < b; }
  // The two that claim() chooses from.
  Query by_first_key(Item a, Item b) const { return first_.claim(a, b); }
  Query by_second_key(Item a, Item b) const { return second_.claim(a, b); }

 private:
  struct Key {
    PredicateId order;
    bool descends;
    Query claim(Item a, Item b) const {
      return descends ? Query(order, {b, a}) : Query(order, {a, b});
    }
  };
  Key key(const std::array<int, 2>& direction) const;

  Kernel* kernel_;
  Key first_, second_;
};

// As of all claims, with one sign less.
bool in_front(Kernel& kernel, const TurnedOrder& order, Item a, Item b);

}  // namespace kinex

#endif
