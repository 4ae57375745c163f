// SPDX-License-Identifier: GPL-3.0-or-later
// PairSums: for bodies that do not turn against each other, the Minkowski sum M of every pair, with
// the hierarchy of its exterior: separation_minkowski.
//
// Seen from A, B is a point that moves outside the fixed convex polygon M. The proof is the tile of
// the exterior's hierarchy that holds the point: a triangle, 3 certificates, or a half-plane beyond
// the box, 1 certificate. The ring between two stages is the difference of two convex sets, so a
// straight line meets it in at most two intervals, each inside one triangle: events, while a pair
// is followed, are at most 2 per level and 8 beyond the box.
//
// Certificates, ties and sources: separation_mixed.h, of which this is the special case where the
// second polygon is a point. Cost: O(n) to build M and O(n depth) for its hierarchy, for every
// pair.
#ifndef KINEX_STRUCTURES_COLLISION_PAIR_SUMS_H
#define KINEX_STRUCTURES_COLLISION_PAIR_SUMS_H

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/engine/bound.h"
#include "predicates/bodies/sum_frame.h"
#include "structures/collision/hierarchy_bounds.h"
#include "structures/collision/pair_table.h"

namespace kinex {

class PairSums {
 public:
  explicit PairSums(PairTable& pairs);

  // The sum under the motions in force. Throws std::invalid_argument if the bodies turn against each
  // other.
  void make(PairId p);
  // The frames of the sum, and of a point, in the place of the two bodies'.
  std::array<BodyFrame*, 2> frames(PairId p) { return {&sums_[p].made->frame, &point_}; }
  // The features of the two bodies at this edge of the hierarchy, on the boundary of M.
  Features features(PairId p, std::uint32_t edge) const;
  // A certificate of the pair's proof has failed.
  void failed(PairId p);

  const HierarchyBounds& hierarchies() const { return hierarchies_; }  // all that were made
  void add_bounds(const BoundContext& context, std::vector<BoundCheck>& checks) const;
  std::size_t bytes() const;

 private:
  struct Sum {
    std::unique_ptr<SumFrame> made;
    bool is_line = false;  // the point moves on a straight line
    std::int64_t failures = 0;
  };
  // The failures while a pair was followed, and their bound.
  struct Line {
    std::int64_t failures = 0, most = 0;
  };
  void note_line(const Sum& sum);

  PairTable& pairs_;
  BodyFrame point_;
  std::vector<Sum> sums_;  // per pair
  HierarchyBounds hierarchies_;
  std::optional<Line> line_;  // the one that came nearest to its bound
};

}  // namespace kinex

#endif
