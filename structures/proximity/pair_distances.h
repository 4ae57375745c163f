// SPDX-License-Identifier: GPL-3.0-or-later
// PairDistances: the claims of a part about pairs of points: the closer pair is in front.
//
// Ties. Of pairs whose distances are identically equal the lexicographically smaller one is in
// front, the smaller id of a pair first.
#ifndef KINEX_STRUCTURES_PROXIMITY_PAIR_DISTANCES_H
#define KINEX_STRUCTURES_PROXIMITY_PAIR_DISTANCES_H

#include <array>

#include "core/engine/kernel.h"
#include "predicates/predicates.h"

namespace kinex {

class PairDistances {
 public:
  using Value = std::array<ObjectId, 2>;  // ascending

  // In 1 to 3 axes; else throws std::invalid_argument.
  PairDistances(Kernel& kernel, int dimension)
      : pairs_(kernel.bind(make_pair_distance_order(dimension))),
        to_common_(kernel.bind(make_squared_distance_order(dimension))) {}

  // "front is at most as long as back": of different pairs, which may share an object.
  Query claim(const Value& front, const Value& back) const {
    for (const int i : {0, 1}) {
      for (const int j : {0, 1}) {
        if (front[i] == back[j]) return Query(to_common_, {front[1 - i], back[1 - j], front[i]});
      }
    }
    return Query(pairs_, {front[0], front[1], back[0], back[1]});
  }
  bool goes_first(const Value& a, const Value& b) const { return a < b; }

 private:
  PredicateId pairs_;      // no object in common
  PredicateId to_common_;  // a query may not name the common object twice
};

}  // namespace kinex

#endif
