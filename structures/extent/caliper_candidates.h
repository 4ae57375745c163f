// SPDX-License-Identifier: GPL-3.0-or-later
// CaliperCandidates: what rotating calipers find on one edge of the hull, and the order of two of
// them.
//
//     measure      candidate of edge a -> b   in front
//     kDiameter    b and its antipode          the farther pair; pairs ascend
//     kWidth       a, b, antipode c           the narrower strip
//     kArea        a, b, r, c, l              the rectangle of smaller area
//     kPerimeter   a, b, r, c, l              the rectangle of smaller perimeter
//
// Every pair of points that admits parallel supporting lines is a candidate of kDiameter, so the
// diameter is one of them. The least strip and the least rectangles are flush with an edge: between
// two directions at which a contact changes the width of a strip is a sinusoid, and so is half a
// perimeter; an area is a + b cos(2x + c). Neither has a minimum inside where it is positive.
//
// Degree of the claims: 2d for kDiameter, otherwise 6d.
//
// Ties. Of candidates that are identically equal the lexicographically smaller one is in front: for
// strips and rectangles that with the smaller tail of its edge.
#ifndef KINEX_STRUCTURES_EXTENT_CALIPER_CANDIDATES_H
#define KINEX_STRUCTURES_EXTENT_CALIPER_CANDIDATES_H

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "structures/extent/calipers.h"
#include "structures/parts/pair_distances.h"
#include "structures/parts/shared_queries.h"

namespace kinex {

// What is extreme: the longest pair, the narrowest strip, the least rectangle.
enum class CaliperMeasure : std::uint8_t { kDiameter, kWidth, kArea, kPerimeter };

// Of the calipers: so many, or a multiple of it.
inline int folds_of(CaliperMeasure measure) {
  return measure == CaliperMeasure::kArea || measure == CaliperMeasure::kPerimeter ? 4 : 2;
}

class CaliperCandidates {
 public:
  using Value = std::array<ObjectId, 5>;  // kNoObject in places that are not used

  CaliperCandidates(Kernel& kernel, CaliperMeasure measure);

  // The ids of a candidate.
  std::size_t size() const {
    return measure_ == CaliperMeasure::kDiameter ? 2 : measure_ == CaliperMeasure::kWidth ? 3 : 5;
  }
  int degree(int motion_degree) const {
    return (measure_ == CaliperMeasure::kDiameter ? 2 : 6) * motion_degree;
  }
  // The candidate of an edge of the calipers' ring; of a segment the edge with the smaller tail has
  // one for kDiameter alone. While a hull changes by several vertices an edge may have none.
  std::optional<Value> of(const Calipers& calipers, ObjectId edge) const;
  // Its ids as an attribute: contacts of edges that are identically tangent are the smaller ends.
  std::vector<ObjectId> shown(const Calipers& calipers, const Value& value) const;

  // The claims of a ChangingExtremum.
  Query claim(const Value& front, const Value& back) const;
  bool goes_first(const Value& a, const Value& b) const { return a < b; }

 private:
  // Contact k of the measure, among those of the calipers.
  int fold(const Calipers& calipers, int k) const {
    return k * (calipers.folds() / folds_of(measure_));
  }

  CaliperMeasure measure_;
  std::optional<PairDistances> distances_;
  std::optional<SharedQueries> orders_;
};

}  // namespace kinex

#endif
