// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/inner_tangents.h"

#include <algorithm>

namespace kinex {

InnerTangents::InnerTangents(Kernel& kernel, StructureId id, const Scene& scene)
    : CollisionPairs(kernel, id, scene, CutPolicy::kMedian) {}

std::vector<std::string_view> InnerTangents::event_kinds() const {
  return collision_kinds({"change"});
}

// Slot 4 k + 2 z + s: tangent k at its vertex of polygon z, against the edge after it (s = 0) or
// before it (s = 1). At the first tangent's vertex the point is beyond the edge after it and within
// the one before; at the second's the other way round.
Query InnerTangents::claim(const SumBoundary& sum, const Tangents& tangents, std::uint32_t slot) {
  const std::size_t k = slot / 4;
  const std::uint8_t z = static_cast<std::uint8_t>(slot / 2 % 2);
  const bool forward = slot % 2 == 0;
  const std::uint32_t own = tangents[k][z], other = tangents[k][SumBoundary::other(z)];
  const std::uint32_t edge = forward ? own : sum.frame(z).before(own);
  if ((k == 0) != forward) return sum.within(z, edge, other);
  return sum.at_touch(z, sum.beyond(z, edge, other));
}

void InnerTangents::enter(PairId p, const SumBoundary& sum, const Tangents& tangents) {
  tangents_[p] = tangents;
  std::array<Query, 8> queries;
  for (std::uint32_t slot = 0; slot < 8; ++slot) queries[slot] = claim(sum, tangents, slot);
  set_certificates(p, queries);
}

bool InnerTangents::start(PairId p) {
  if (tangents_.size() <= p) tangents_.resize(p + std::size_t{1});
  const SumBoundary sum = boundary(p);
  const std::vector<SumBoundary::Edge> edges = sum.edges();
  std::vector<Sign> signs;  // positive where the point is beyond the edge
  for (const SumBoundary::Edge& edge : edges) {
    signs.push_back(sum.sign(sum.beyond(edge.z, edge.edge, edge.vertex)));
  }
  // A point that stays on an edge sees that one.
  const bool outside = std::find(signs.begin(), signs.end(), Sign::kPositive) != signs.end();
  std::vector<bool> seen;
  for (const Sign sign : signs) {
    seen.push_back(sign == Sign::kPositive || (!outside && sign == Sign::kZero));
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

SumBoundary::Edge InnerTangents::beside(const SumBoundary& sum, const Touch& touch, bool forward) {
  return sum.beside(touch[0], touch[1], forward);
}

// The point lies in the edge's direction from its first end; or (not forward) against it from the
// last one.
bool InnerTangents::is_along(const SumBoundary& sum, const SumBoundary::Edge& edge, bool forward) {
  const Query claim = forward ? sum.past(edge.z, edge.edge, false, edge.vertex)
                              : sum.short_of(edge.z, edge.edge, true, edge.vertex);
  return sum.sign(claim) == Sign::kPositive;
}

// The cones of the two vertices share a normal, so their sum is a vertex of M.
bool InnerTangents::is_vertex(const SumBoundary& sum, const Touch& touch) {
  const auto& [x, y] = touch;
  const std::uint32_t e = sum.frame(0).before(x), f = sum.frame(1).before(y);
  return sum.before(0, e, f) ? sum.before(1, f, x) : sum.before(0, e, y);
}

// At the instant at which two edges that meet in a vertex of M become parallel, this vertex moves
// into M and the sum of the edges' other ends comes out.
InnerTangents::Touch InnerTangents::on_boundary(const SumBoundary& sum, const Touch& touch) {
  if (!kernel_.tells_sign_now() || is_vertex(sum, touch)) return touch;
  BodyFrame &a = sum.frame(0), &b = sum.frame(1);
  // And not opposite: the edge after f is then less than half a turn ahead.
  const auto are_parallel = [&](std::uint32_t e, std::uint32_t f) {
    return kernel_.sign(sum.order_before(0, e, f), When::kNow) == Sign::kZero &&
           kernel_.sign(sum.order_before(0, e, b.after(f)), When::kNow) == Sign::kPositive;
  };
  auto [x, y] = touch;
  for (std::uint32_t i = a.size() + b.size(); i > 0; --i) {
    if (are_parallel(a.before(x), y)) {
      x = a.before(x);
      y = b.after(y);
    } else if (are_parallel(x, b.before(y))) {
      x = a.after(x);
      y = b.before(y);
    } else {
      break;
    }
    if (is_vertex(sum, {x, y})) return {x, y};
  }
  return touch;
}

// A tangent's vertex divides the edges of M that the point sees from those that it does not. When
// several certificates fail together, the vertex moves along the boundary of M: outwards if the
// next edge there is seen, or at least not unseen; else inwards; after the point, where this slides
// along two edges of one line. If the tangents meet, nothing is seen, unless the point is beside
// the vertex: then it passes the vertex outside.
void InnerTangents::fail(PairId p, std::uint32_t slot) {
  const SumBoundary sum = boundary(p);
  Tangents tangents = tangents_[p];
  const auto seen = [&sum](const SumBoundary::Edge& edge) {
    return sum.sign(sum.beyond(edge.z, edge.edge, edge.vertex));
  };
  const std::size_t k = slot / 4;
  for (Touch& touch : tangents) touch = on_boundary(sum, touch);
  const bool was_inside = tangents[k] != tangents_[p][k];
  const bool outwards = k == 1;  // forwards
  const SumBoundary::Edge outer = beside(sum, tangents[k], outwards);
  const SumBoundary::Edge inner = beside(sum, tangents[k], !outwards);
  const Sign at_outer = seen(outer);
  bool goes_outwards = at_outer == Sign::kPositive;
  if (at_outer == Sign::kZero) {
    const Sign at_inner = seen(inner);
    goes_outwards =
        at_inner == Sign::kNegative || (at_inner == Sign::kZero && is_along(sum, outer, outwards));
  }
  if (goes_outwards) {
    tangents[k] = sum.end(outer, outwards);
  } else if (!was_inside || seen(inner) == Sign::kNegative) {
    tangents[k] = sum.end(inner, !outwards);
  }
  if (tangents[0] == tangents[1]) {
    const SumBoundary::Edge after = beside(sum, tangents[0], true);
    const SumBoundary::Edge before = beside(sum, tangents[0], false);
    if (seen(after) != Sign::kNegative) {
      tangents[1] = sum.end(after, true);
    } else if (seen(before) != Sign::kNegative) {
      tangents[0] = sum.end(before, false);
    } else {
      contact(p, at(inner));
      return;
    }
  }
  enter(p, sum, tangents);
  report(p, kChange);
}

CollisionPairs::Features InnerTangents::at(const SumBoundary::Edge& edge) {
  const Feature line{true, edge.edge}, other{false, edge.vertex};
  return edge.z == 0 ? Features{line, other} : Features{other, line};
}

// All edges that the point sees lie on at most two lines, which meet where it is.
std::optional<CollisionPairs::Features> InnerTangents::touch(PairId p, When when) {
  const SumBoundary sum = boundary(p);
  const Tangents& tangents = tangents_[p];
  const auto is_on_line = [&](const SumBoundary::Edge& edge) {
    return sign(sum.beyond(edge.z, edge.edge, edge.vertex), when) == Sign::kZero;
  };
  if (!is_on_line(beside(sum, tangents[1], false))) return std::nullopt;
  Touch at_first = tangents[0];
  // Two edges lie on one line if they are parallel.
  for (int i = 0; i < 4; ++i) {
    const SumBoundary::Edge edge = beside(sum, at_first, true);
    if (!is_on_line(edge)) break;
    if (sign(sum.past(edge.z, edge.edge, false, edge.vertex), when) != Sign::kNegative &&
        sign(sum.short_of(edge.z, edge.edge, true, edge.vertex), when) != Sign::kNegative) {
      return at(edge);
    }
    at_first = sum.end(edge, true);
  }
  return std::nullopt;
}

std::optional<InnerTangents::Tangents> InnerTangents::tangents(ObjectId a, ObjectId b) const {
  for (PairId p = 0; p < pairs(); ++p) {
    if (pair(p).a == a && pair(p).b == b && !pair(p).touching) return tangents_[p];
  }
  return std::nullopt;
}

std::size_t InnerTangents::bytes() const {
  return CollisionPairs::bytes() + tangents_.capacity() * sizeof(Tangents);
}

}  // namespace kinex
