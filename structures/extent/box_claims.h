// SPDX-License-Identifier: GPL-3.0-or-later
// BoxClaims: the claims of a part about boxes with sides along fixed directions: the one of smaller
// area, or of smaller perimeter, is in front.
//
// A box is named by its direction and the extreme objects of this direction, of the opposite one,
// and of both turned by 90 degrees. The predicate of two directions is bound when it is first
// needed (predicates/points/box_order.h); an object may be extreme in several directions.
//
// Ties. Of boxes that are identically equal the one of the smaller direction is in front.
#ifndef KINEX_STRUCTURES_EXTENT_BOX_CLAIMS_H
#define KINEX_STRUCTURES_EXTENT_BOX_CLAIMS_H

#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "core/engine/kernel.h"
#include "predicates/points/box_order.h"
#include "structures/parts/shared_queries.h"

namespace kinex {

class BoxClaims {
 public:
  // Direction; the extreme objects along it and against it, and along it turned by 90 degrees and
  // against that.
  using Value = std::array<ObjectId, 5>;

  // `directions`: of one side of each box, unit vectors.
  BoxClaims(Kernel& kernel, std::vector<DirectionVector> directions, BoxMeasure measure)
      : kernel_(&kernel), directions_(std::move(directions)), measure_(measure) {}

  BoxMeasure measure() const { return measure_; }
  int degree(int motion_degree) const {
    return measure_ == BoxMeasure::kArea ? 2 * motion_degree : motion_degree;
  }
  // Of two different directions.
  Query claim(const Value& front, const Value& back) const;
  bool goes_first(const Value& a, const Value& b) const { return a < b; }

 private:
  const SharedQueries& queries(ObjectId i, ObjectId j, SmallerBox smaller) const;

  Kernel* kernel_;
  std::vector<DirectionVector> directions_;
  BoxMeasure measure_;
  mutable std::map<std::tuple<ObjectId, ObjectId, SmallerBox>, SharedQueries> bound_;
};

}  // namespace kinex

#endif
