// SPDX-License-Identifier: GPL-3.0-or-later
// PairDistances: claims (structures/parts/claim.h) about pairs of points: the closer pair is in
// front.
//
// Ties. Of two pairs with identically equal distances the lexicographically smaller one is in
// front.
#ifndef KINEX_STRUCTURES_PARTS_PAIR_DISTANCES_H
#define KINEX_STRUCTURES_PARTS_PAIR_DISTANCES_H

#include <array>

#include "core/engine/kernel.h"
#include "predicates/predicates.h"

namespace kinex {

class PairDistances {
 public:
  using Value = std::array<ObjectId, 2>;  // a pair, ids ascending

  // Throws std::invalid_argument unless the dimension is 1, 2 or 3.
  PairDistances(Kernel& kernel, int dimension)
      : pairs_(kernel.bind(make_pair_distance_order(dimension))),
        to_common_(kernel.bind(make_squared_distance_order(dimension))) {}

  // "The points of `front` are at most as far apart as those of `back`." The pairs must differ;
  // they may share an object.
  Query claim(const Value& front, const Value& back) const {
    for (const int i : {0, 1}) {
      for (const int j : {0, 1}) {
        if (front[i] == back[j]) return Query(to_common_, {front[1 - i], back[1 - j], front[i]});
      }
    }
    return Query(pairs_, {front[0], front[1], back[0], back[1]});
  }
  // Resolves ties.
  bool goes_first(const Value& a, const Value& b) const { return a < b; }

 private:
  PredicateId pairs_;      // for pairs without a common object
  PredicateId to_common_;  // for pairs with one: a query must not name an object twice
};

}  // namespace kinex

#endif
