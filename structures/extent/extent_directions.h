// SPDX-License-Identifier: GPL-3.0-or-later
// ExtentDirections: the diameter or the width of moving points in the plane, to a proven error: the
// largest or the smallest of their extents along 2k directions. The diameter in space likewise, along
// those of predicates/points/unit_directions_3.h.
//
// Certificates. The extreme objects of 4k directions (DirectionMaxima), and a tournament of the 2k
// extents u_i.(high - low): "the extent in u_i is at least (at most) that in u_j". All have degree
// d in t for motions of degree d, so the failure times of linear motions are rational. (The exact
// diameter needs 2d, the exact width 6d.)
//
//         :        high
//         :       .  :          the extent in one direction: between two lines across it,
//         :   .      :          through the extreme objects
//        low   .  .  :
//         :<-------->:
//
// Quality. For the true diameter D, the true width w and the extent E that is found, at all times:
//
//   diameter   D^2 k^2 / (k^2 + 1) <= E^2 <= |high - low|^2 <= D^2
//     in space   D^2 (1 - 1/k^2)^2 <= E^2 <= |high - low|^2 <= D^2
//   width      w <= E <= w + D / sqrt(k^2 + 1)
//
// Beside the certificates of the extreme objects 2k - 1. A failure renews O(log k) of them. For n
// points that move linearly the diameter changes at most 2k(n + 1) - 1 times: each extent is convex and
// piecewise linear with at most n + 1 pieces, so their maximum is the upper envelope of 2k(n + 1) lines.
// (Equal extents are no exception: the first direction wins as if it were larger by an infinitesimal
// constant, with which its extent stays convex.)
//
// Attribute. The two extreme objects of the direction, ascending; none if all points are one, or,
// for the width, if all are on a line across a direction: then the extent is zero.
//
// Ties. Of objects that are identically level in a direction the smallest id is extreme; of extents
// that are identically equal the one of the first direction counts.
//
// Source: Agarwal, Har-Peled, "Maintaining approximate extent measures of moving points" (2001).
#ifndef KINEX_STRUCTURES_EXTENT_EXTENT_DIRECTIONS_H
#define KINEX_STRUCTURES_EXTENT_EXTENT_DIRECTIONS_H

#include <algorithm>
#include <string_view>
#include <vector>

#include "predicates/points/unit_directions_3.h"
#include "structures/extent/best_direction.h"
#include "structures/extent/extent_claims.h"

namespace kinex {

class ExtentDirections final : public BestDirection<ExtentClaims> {
 public:
  // k >= 1. kMaximum: the diameter, in the plane or in space, where more than kMostInSpace counts as
  // that; kMinimum: the width in the plane. Throws std::invalid_argument for another dimension.
  static constexpr int kMostInSpace = 6;
  ExtentDirections(Kernel& kernel, StructureId id, const Scene& scene, int k, Extremum extremum);
  // The directions that extents are measured along, one of each two opposite ones.
  static std::vector<DirectionVector> directions(int k, int dimension) {
    return unit_directions(dimension == 3 ? std::min(k, kMostInSpace) : k, dimension);
  }

  std::string_view name() const override {
    return maximum() ? "diameter_directions" : "width_directions";
  }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;

 private:
  bool maximum() const { return values().claims().extremum() == Extremum::kMaximum; }
  std::vector<ObjectId> best() const override;

  int k_, dimension_;
};

}  // namespace kinex

#endif
