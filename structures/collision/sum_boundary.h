// SPDX-License-Identifier: GPL-3.0-or-later
// SumBoundary: the boundary of the Minkowski sum M of A and R B' right after now, in terms of the
// polygons' own edges and vertices.
//
// Every edge of M is an edge of one polygon translated by a vertex of the other, whose cone holds
// the edge's normal; every vertex of M is the sum of two vertices. Of two identically parallel
// edges A's comes first.
#ifndef KINEX_STRUCTURES_COLLISION_SUM_BOUNDARY_H
#define KINEX_STRUCTURES_COLLISION_SUM_BOUNDARY_H

#include <array>
#include <cstdint>
#include <vector>

#include "core/engine/kernel.h"
#include "predicates/bodies/body_frames.h"
#include "predicates/bodies/pose_predicates.h"

namespace kinex {

// A feature of a body: vertex or edge `i` of the polygon of its frame.
struct Feature {
  bool edge = false;
  std::uint32_t i = 0;
};
struct Features {  // a feature of each body, that of the second one in its negated frame
  Feature of_a, of_b;
};

class SumBoundary {
 public:
  using Id = std::uint32_t;
  // Edge `edge` of polygon z, at vertex `vertex` of the other.
  struct Edge {
    std::uint8_t z;
    Id edge, vertex;
    friend bool operator==(const Edge&, const Edge&) = default;
    Features features() const {
      const Feature line{true, edge}, point{false, vertex};
      return z == 0 ? Features{line, point} : Features{point, line};
    }
  };

  // `frames[1]` is B'. The references must live as long as this object.
  SumBoundary(Kernel& kernel, const PosePredicates& predicates, ObjectId pose,
              std::array<BodyFrame*, 2> frames)
      : kernel_(kernel), predicates_(predicates), pose_(pose), frames_(frames) {}

  BodyFrame& frame(std::uint8_t z) const { return *frames_[z]; }
  static std::uint8_t other(std::uint8_t z) { return static_cast<std::uint8_t>(1 - z); }
  // Queries on the pose, >= 0 where they hold; degrees: predicates/bodies/pose_2.h.
  //   (1) within = -beyond   (2) short_of = -past   (3) order_before = -order_after
  //   (4) order_after(0, e, f) = order_before(1, f, e)
  // The point is on the outer side of edge e of polygon z at vertex v of the other (beyond), or on
  // the inner side (within).
  Query beyond(std::uint8_t z, Id e, Id v) const {
    return predicates_.side(z, {pose_, frame(z).polygon_edge(e), frame(other(z)).vertex(v)});
  }
  Query beyond(const Edge& edge) const { return beyond(edge.z, edge.edge, edge.vertex); }
  Query within(std::uint8_t z, Id e, Id v) const {
    return predicates_.inside(z, {pose_, frame(z).polygon_edge(e), frame(other(z)).vertex(v)});
  }
  // The same query, failing at touches too (core/arithmetic/touch.h).
  Query at_touch(const Query& query) const { return predicates_.at_touch(query); }
  // The point is past (short of) the line across edge e of polygon z at its first or last end, at
  // vertex v: on the side that the edge points to, or on the other one.
  Query past(std::uint8_t z, Id e, bool last, Id v) const {
    return predicates_.side(z, {pose_, frame(z).across(e, last), frame(other(z)).vertex(v)});
  }
  Query past(const Edge& edge, bool last) const {
    return past(edge.z, edge.edge, last, edge.vertex);
  }
  Query short_of(std::uint8_t z, Id e, bool last, Id v) const {
    return predicates_.inside(z, {pose_, frame(z).across(e, last), frame(other(z)).vertex(v)});
  }
  Query short_of(const Edge& edge, bool last) const {
    return short_of(edge.z, edge.edge, last, edge.vertex);
  }
  // The normal of edge e of polygon z is after (counter-clockwise from) that of edge f of the
  // other, or before it.
  Query order_after(std::uint8_t z, Id e, Id f) const {
    return predicates_.order_after(z, lines(z, e, f));
  }
  Query order_before(std::uint8_t z, Id e, Id f) const {
    return predicates_.order_before(z, lines(z, e, f));
  }
  Sign sign(const Query& query) const { return kernel_.sign_after(query); }
  bool holds(const Query& query) const { return sign(query) != Sign::kNegative; }
  bool before(std::uint8_t z, Id e, Id f) const;
  // The point lies in the edge's direction from its first end; or (not forward) against it from the
  // last one.
  bool is_along(const Edge& edge, bool forward) const {
    return sign(forward ? past(edge, false) : short_of(edge, true)) == Sign::kPositive;
  }

  // The edge of M after (before) its vertex x + y: of the two candidates, one of either polygon,
  // the one whose normal is nearer.
  Edge beside(Id x, Id y, bool forward) const;
  // The vertex of M at the edge's first or last end: a vertex of A, one of B'.
  std::array<Id, 2> end(const Edge& edge, bool last) const;
  // All edges of M, counter-clockwise, from the first edge of A on: O(n_A + n_B) signs.
  std::vector<Edge> edges() const;

 private:
  PosePredicates::Lines lines(std::uint8_t z, Id e, Id f) const {
    return {pose_, frame(z).polygon_edge(e), frame(other(z)).polygon_edge(f)};
  }

  Kernel& kernel_;
  const PosePredicates& predicates_;
  ObjectId pose_;
  std::array<BodyFrame*, 2> frames_;
};

}  // namespace kinex

#endif
