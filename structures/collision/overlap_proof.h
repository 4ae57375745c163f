// SPDX-License-Identifier: GPL-3.0-or-later
// OverlapProof: a kinetic proof that two convex polygons overlap; it fails where they part.
//
// The bodies overlap while the point t lies inside M, the Minkowski sum of A and R B'
// (sum_boundary.h). A point c inside M is chosen once: a point inside A plus one inside B'. The ray
// from c through t leaves M through one edge, the edge ahead:
//
//     first *-----------* last     the edge ahead, on the boundary of M
//            \    t    /
//             \   .   /
//              \  .  /
//                 c
//
// Certificates, all "non-negative":
//   0     t is on the inner side of the line of the edge ahead; fails where the bodies part
//   1     t is to the left of the ray from c through the edge's first end
//   2     t is to the right of the ray from c through the edge's last end
//   3, 4  the edge belongs to M: its normal lies between those of the two edges at the other
//         polygon's vertex
// Compactness: 5 certificates. Responsiveness: O(1) signs where t moves from one edge to the next,
// O(n) where it passes through c. The same edge names the features that meet when t reaches the
// boundary of M, whichever structure detected it.
//
// Ties. Where t is on a ray, or stays on c, any edge ahead will do. Degrees: those of the pose.
// Source: a fan of triangles about an interior point; worked out here.
#ifndef KINEX_STRUCTURES_COLLISION_OVERLAP_PROOF_H
#define KINEX_STRUCTURES_COLLISION_OVERLAP_PROOF_H

#include <array>
#include <cstdint>
#include <optional>

#include "core/engine/kernel.h"
#include "structures/collision/sum_boundary.h"

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
  // The edge ahead right after now, searched from any edge of either polygon at a vertex of the
  // other: O(1) signs for each edge passed. t may be outside M. nullopt only in an inexact
  // arithmetic: the search did not end.
  std::optional<Edge> ahead(Edge from) const;
  // True if t lies strictly on the inner side of the edge's line right after now.
  bool is_inside(const Edge& edge) const;

 private:
  Query ray(PredicateId predicate, const Edge& edge, bool last) const;

  const RayPredicates& rays_;
  const SumBoundary& sum_;
  ObjectId pose_, inner_a_, inner_b_;
};

}  // namespace kinex

#endif
