// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/overlap_proof.h"

#include "predicates/bodies/pose_2.h"

namespace kinex {
RayPredicates::RayPredicates(Kernel& kernel)
    : left(kernel.bind(make_pose_ray(false))), right(kernel.bind(make_pose_ray(true))) {}

OverlapProof::OverlapProof(const RayPredicates& rays, const SumBoundary& sum, ObjectId pose)
    : rays_(rays),
      sum_(sum),
      pose_(pose),
      inner_a_(sum.frame(0).inner()),
      inner_b_(sum.frame(1).inner()) {}

Query OverlapProof::ray(PredicateId predicate, const Edge& edge, bool last) const {
  const auto [x, y] = sum_.end(edge, last);
  return Query(predicate,
               {pose_, inner_a_, inner_b_, sum_.frame(0).vertex(x), sum_.frame(1).vertex(y)});
}

Query OverlapProof::certificate(const Edge& edge, std::uint32_t slot) const {
  const BodyFrame& other = sum_.frame(SumBoundary::other(edge.z));
  switch (slot) {
    case kInside:
      return sum_.within(edge.z, edge.edge, edge.vertex);
    case 1:
      return ray(rays_.left, edge, false);
    case 2:
      return ray(rays_.right, edge, true);
    case 3:
      return sum_.order_after(edge.z, edge.edge, other.before(edge.vertex));
    default:
      return sum_.order_before(edge.z, edge.edge, edge.vertex);
  }
}

std::array<Query, OverlapProof::kCertificates> OverlapProof::certificates(const Edge& edge) const {
  std::array<Query, kCertificates> all;
  for (std::uint32_t slot = 0; slot < kCertificates; ++slot) all[slot] = certificate(edge, slot);
  return all;
}

bool OverlapProof::is_inside(const Edge& edge) const {
  return sum_.sign(certificate(edge, kInside)) == Sign::kPositive;
}

// The search first finds the vertex whose cone holds the edge's normal, always in the same
// direction; then it follows M, again always in the same direction.
std::optional<OverlapProof::Edge> OverlapProof::ahead(Edge from) const {
  const BodyFrame& other = sum_.frame(SumBoundary::other(from.z));
  std::uint32_t steps = 0;
  for (; steps <= other.size(); ++steps) {
    const SumBoundary::Id before = other.before(from.vertex);
    if (!sum_.before(from.z, from.edge, from.vertex)) {
      from.vertex = other.after(from.vertex);
    } else if (sum_.before(from.z, from.edge, before)) {
      from.vertex = before;
    } else {
      break;
    }
  }
  if (steps > other.size()) return std::nullopt;
  const std::uint32_t all = sum_.frame(0).size() + sum_.frame(1).size();
  for (steps = 0; steps <= all; ++steps) {
    if (!sum_.holds(certificate(from, 1))) {
      const auto [x, y] = sum_.end(from, false);
      from = sum_.beside(x, y, false);
    } else if (!sum_.holds(certificate(from, 2))) {
      const auto [x, y] = sum_.end(from, true);
      from = sum_.beside(x, y, true);
    } else {
      return from;
    }
  }
  return std::nullopt;
}

}  // namespace kinex
