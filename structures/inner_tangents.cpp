// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/inner_tangents.h"

namespace kinex {

InnerTangents::InnerTangents(Kernel& kernel, StructureId id, const Scene& scene)
    : CollisionPairs(kernel, id, scene, CutPolicy::kMedian), predicates_(kernel) {}

std::vector<std::string_view> InnerTangents::event_kinds() const {
  return collision_kinds({"change"});
}

SumBoundary InnerTangents::boundary(PairId p) {
  return SumBoundary(kernel_, predicates_, pair(p).pose,
                     {&frames_.frame(pair(p).a, false), &frames_.frame(pair(p).b, true)});
}

// Slot 4 k + 2 z + s: of tangent k, at its vertex of polygon z, the edge after it (s = 0) or before
// it. The first tangent's vertex has the point beyond the edge after it and within the one before;
// the second's the other way round.
void InnerTangents::enter(PairId p, const SumBoundary& sum, const Tangents& tangents) {
  tangents_[p] = tangents;
  std::array<Query, 8> queries;
  std::size_t slot = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::uint8_t z = 0; z < 2; ++z) {
      const std::uint32_t own = tangents[k][z], other = tangents[k][SumBoundary::other(z)];
      const std::uint32_t before = sum.frame(z).before(own);
      queries[slot++] = k == 0 ? sum.beyond(z, own, other) : sum.within(z, own, other);
      queries[slot++] = k == 0 ? sum.within(z, before, other) : sum.beyond(z, before, other);
    }
  }
  set_certificates(p, queries);
}

bool InnerTangents::start(PairId p) {
  if (tangents_.size() <= p) tangents_.resize(p + std::size_t{1});
  const SumBoundary sum = boundary(p);
  const std::vector<SumBoundary::Edge> edges = sum.edges();
  std::vector<bool> seen;  // the point is beyond the edge
  for (const SumBoundary::Edge& edge : edges) {
    seen.push_back(sum.sign(sum.beyond(edge.z, edge.edge, edge.vertex)) == Sign::kPositive);
  }
  Tangents tangents{};
  bool found = false;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::size_t previous = i == 0 ? edges.size() - 1 : i - 1;
    if (seen[i] == seen[previous]) continue;
    found = true;
    // The vertex of M at the first end of edge i.
    const SumBoundary::Edge& edge = edges[i];
    tangents[seen[i] ? 0 : 1] = {edge.z == 0 ? edge.edge : edge.vertex,
                                 edge.z == 0 ? edge.vertex : edge.edge};
  }
  if (!found) return false;
  enter(p, sum, tangents);
  return true;
}

void InnerTangents::fail(PairId p, std::uint32_t slot) {
  const SumBoundary sum = boundary(p);
  Tangents tangents = tangents_[p];
  const std::size_t k = slot / 4;
  const std::uint8_t z = static_cast<std::uint8_t>(slot / 2 % 2);
  const bool forward = slot % 2 == 0;
  std::uint32_t& vertex = tangents[k][z];
  const std::uint32_t edge = forward ? vertex : sum.frame(z).before(vertex);
  vertex = forward ? sum.frame(z).after(vertex) : edge;
  if (tangents[0] == tangents[1]) {
    const Feature line{true, edge}, other{false, tangents[k][SumBoundary::other(z)]};
    contact(p, z == 0 ? line : other, z == 0 ? other : line);
    return;
  }
  enter(p, sum, tangents);
  report(p, kChange);
}

std::size_t InnerTangents::bytes() const {
  return CollisionPairs::bytes() + tangents_.capacity() * sizeof(Tangents);
}

}  // namespace kinex
