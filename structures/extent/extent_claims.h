// SPDX-License-Identifier: GPL-3.0-or-later
// ExtentClaims: the claims of a part about extents: the larger one is in front, or the smaller one.
//
// An extent is u_i.(high - low), of the two extreme objects of direction i and its opposite; they
// are different objects. The predicate of two directions is bound when it is first needed, one for
// each way in which the two extents may have objects in common (a query may not name one twice).
//
// Ties. Of extents that are identically equal the one of the smaller direction is in front.
#ifndef KINEX_STRUCTURES_EXTENT_EXTENT_CLAIMS_H
#define KINEX_STRUCTURES_EXTENT_EXTENT_CLAIMS_H

#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "core/engine/kernel.h"
#include "predicates/points/unit_directions.h"
#include "structures/parts/key_order.h"

namespace kinex {

class ExtentClaims {
 public:
  using Value = std::array<ObjectId, 3>;  // direction, high, low

  ExtentClaims(Kernel& kernel, std::vector<DirectionVector> directions, Extremum extremum)
      : kernel_(&kernel), directions_(std::move(directions)), extremum_(extremum) {}

  const std::vector<DirectionVector>& directions() const { return directions_; }
  Extremum extremum() const { return extremum_; }
  // Of two different directions.
  Query claim(const Value& front, const Value& back) const;
  bool goes_first(const Value& a, const Value& b) const { return a < b; }

 private:
  PredicateId predicate(ObjectId i, ObjectId j, const std::array<int, 4>& places,
                        bool negated) const;

  Kernel* kernel_;
  std::vector<DirectionVector> directions_;
  Extremum extremum_;
  // By two directions, the place of the first end of each of the four in the query, and whether both
  // directions are negated.
  mutable std::map<std::tuple<ObjectId, ObjectId, std::array<int, 4>, bool>, PredicateId> bound_;
};

}  // namespace kinex

#endif
