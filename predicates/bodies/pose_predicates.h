// SPDX-License-Identifier: GPL-3.0-or-later
// PosePredicates: the predicates on poses (predicates/bodies/pose_2.h), bound once per structure, and
// the queries that they answer.
#ifndef KINEX_PREDICATES_BODIES_POSE_PREDICATES_H
#define KINEX_PREDICATES_BODIES_POSE_PREDICATES_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/engine/kernel.h"

namespace kinex {

class PosePredicates {
 public:
  explicit PosePredicates(Kernel& kernel);

  // Arguments, in the order in which constants are made where they are new: of a braced list.
  struct AtPoint {
    ObjectId pose, line, point;
  };
  // Two lines of frames, and the pose between these.
  struct Lines {
    ObjectId pose, own, foreign;
  };
  // Queries on a pose, >= 0 where they hold. z: the polygon that a line or an edge belongs to, 0 for
  // A, 1 for B'. Lines and points are constants of frames.
  //   (1) inside = -side   (2) order_before = -order_after
  //   (3) order_after(0, m, g) = order_before(1, g, m)
  //   (4) at_touch(query) has the sign of `query`
  // The moving point is on the outer side of the line at a point of the other polygon, or on its
  // inner side.
  Query side(std::uint8_t z, const AtPoint& at) const {
    return Query(side_[z], {at.pose, at.line, at.point});
  }
  Query inside(std::uint8_t z, const AtPoint& at) const {
    return Query(inside_[z], {at.pose, at.line, at.point});
  }
  // It is in the direction of the line from the sum of a point of A and one of B'.
  Query along(std::uint8_t z, ObjectId pose, ObjectId line, ObjectId of_a, ObjectId of_b) const {
    return Query(along_[z], {pose, line, of_a, of_b});
  }
  // The normal of `own`, a line of polygon z, is before (clockwise from) that of `foreign`, a line of
  // the other one, or after it. A's line comes first in the query.
  Query order_before(std::uint8_t z, const Lines& lines) const { return order(z, lines, 1 - z); }
  Query order_after(std::uint8_t z, const Lines& lines) const { return order(z, lines, z); }
  // The same query about a side or an order, failing at touches too (core/arithmetic/touch.h).
  Query at_touch(Query query) const;
  // The same for `along`, or for its negated value.
  Query along_at_touch(Query along, bool against) const;
  // What a query of these says about a tile: "side of the tile".
  bool is_about_side(const Query& query) const;
  bool is_about_end(const Query& query) const;
  // The signs of all these predicates that have been computed so far.
  std::uint64_t signs_asked(const Kernel& kernel) const;

 private:
  using ByFrame = std::array<PredicateId, 2>;  // indexed by the frame of the line
  Query order(std::uint8_t z, const Lines& lines, int reversed) const {
    const PredicateId predicate = order_[static_cast<std::size_t>(reversed)];
    return z == 0 ? Query(predicate, {lines.pose, lines.own, lines.foreign})
                  : Query(predicate, {lines.pose, lines.foreign, lines.own});
  }
  ByFrame side_, inside_, along_, touch_, touch_inside_, along_touch_, against_touch_;
  // of A's normal and that of B', and the reverse
  ByFrame order_, order_touch_;
};

}  // namespace kinex

#endif
