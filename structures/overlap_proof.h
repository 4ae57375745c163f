// SPDX-License-Identifier: GPL-3.0-or-later
// OverlapProof: that two convex polygons overlap, and where they would part.
//
// The bodies overlap while the point t lies inside M, the Minkowski sum of A and R B'
// (structures/sum_boundary.h). A point c inside M is chosen once: a point inside A plus one
// inside B'. The ray from c through t leaves M by one edge, the edge ahead. Certificates, all
// "non-negative":
//   0     t is on the inner side of that edge's line; when it fails the bodies part there
//   1, 2  t is to the left of the ray from c through the edge's first end, to the right of that
//         through its last one
//   3, 4  the edge is one of M: its normal lies between those of the edges at the other polygon's
//         vertex
// Compactness: 5 certificates. Responsiveness: O(1) signs where t moves from an edge to the next,
// O(n) where it goes through c. The same edge names the features that meet when t comes to the
// boundary of M, whatever structure saw it come.
//
// Ties. Where t is on a ray, or stays on c, any edge ahead will do. Degrees: those of the pose.
// Source: a fan of triangles about a point inside; worked out here.
#ifndef KINEX_STRUCTURES_OVERLAP_PROOF_H
#define KINEX_STRUCTURES_OVERLAP_PROOF_H

#include <array>
#include <cstdint>
#include <optional>

#include "core/kernel.h"
#include "structures/sum_boundary.h"

namespace kinex {

// The predicates on rays, bound once per structure.
struct RayPredicates {
  explicit RayPredicates(Kernel& kernel);
  PredicateId left, right;
};

class OverlapProof {
 public:
  using Edge = SumBoundary::Edge;
  static constexpr std::uint32_t kCertificates = 5, kInside = 0;

  // The references must live as long as this object.
  OverlapProof(const RayPredicates& rays, const SumBoundary& sum, ObjectId pose);

  Query certificate(const Edge& edge, std::uint32_t slot) const;
  std::array<Query, kCertificates> certificates(const Edge& edge) const;
  // The edge ahead right after now, from some edge of either polygon at a vertex of the other on:
  // O(1) signs for each edge in between. t may be outside. nullopt: an inexact arithmetic does not
  // come to an end.
  std::optional<Edge> ahead(Edge from) const;
  // t lies strictly within the edge's line right after now.
  bool is_inside(const Edge& edge) const;

 private:
  Query ray(PredicateId predicate, const Edge& edge, bool last) const;
  bool holds(const Query& query) const { return sum_.sign(query) != Sign::kNegative; }

  const RayPredicates& rays_;
  const SumBoundary& sum_;
  ObjectId pose_, inner_a_, inner_b_;
};

}  // namespace kinex

#endif
