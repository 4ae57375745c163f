// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/inner_tangents.h"

#include <algorithm>

namespace kinex {

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
  return sum.at_touch(sum.beyond(z, edge, other));
}

void InnerTangents::enter(PairId p, const SumBoundary& sum, const Tangents& tangents) {
  tangents_[p] = tangents;
  std::array<Query, 8> queries;
  for (std::uint32_t slot = 0; slot < 8; ++slot) queries[slot] = claim(sum, tangents, slot);
  pairs_.set(p, slots_, queries);
}

bool InnerTangents::start(PairId p, const Edge*) {
  if (tangents_.size() <= p) tangents_.resize(p + std::size_t{1});
  const SumBoundary sum = pairs_.boundary(p);
  const std::vector<Edge> edges = sum.edges();
  std::vector<Sign> signs;  // positive where the point is beyond the edge
  for (const Edge& edge : edges) signs.push_back(sum.sign(sum.beyond(edge)));
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
    tangents[seen[i] ? 0 : 1] = sum.end(edges[i], false);
  }
  if (!found) return false;
  enter(p, sum, tangents);
  return true;
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
  Kernel& kernel = pairs_.kernel();
  if (!kernel.tells_sign_now() || is_vertex(sum, touch)) return touch;
  BodyFrame &a = sum.frame(0), &b = sum.frame(1);
  // And not opposite: the edge after f is then less than half a turn ahead.
  const auto are_parallel = [&](std::uint32_t e, std::uint32_t f) {
    return kernel.sign(sum.order_before(0, e, f), When::kNow) == Sign::kZero &&
           kernel.sign(sum.order_before(0, e, b.after(f)), When::kNow) == Sign::kPositive;
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
SeparationProof::Repair InnerTangents::repair(PairId p, std::uint32_t slot) {
  const SumBoundary sum = pairs_.boundary(p);
  Tangents tangents = tangents_[p];
  const auto seen = [&sum](const Edge& edge) { return sum.sign(sum.beyond(edge)); };
  const std::size_t k = slot / 4;
  for (Touch& touch : tangents) touch = on_boundary(sum, touch);
  const bool was_inside = tangents[k] != tangents_[p][k];
  const bool outwards = k == 1;  // forwards
  const Edge outer = beside(sum, tangents[k], outwards);
  const Edge inner = beside(sum, tangents[k], !outwards);
  const Sign at_outer = seen(outer);
  bool goes_outwards = at_outer == Sign::kPositive;
  if (at_outer == Sign::kZero) {
    const Sign at_inner = seen(inner);
    goes_outwards =
        at_inner == Sign::kNegative || (at_inner == Sign::kZero && sum.is_along(outer, outwards));
  }
  if (goes_outwards) {
    tangents[k] = sum.end(outer, outwards);
  } else if (!was_inside || seen(inner) == Sign::kNegative) {
    tangents[k] = sum.end(inner, !outwards);
  }
  if (tangents[0] == tangents[1]) {
    const Edge after = beside(sum, tangents[0], true);
    const Edge before = beside(sum, tangents[0], false);
    if (seen(after) != Sign::kNegative) {
      tangents[1] = sum.end(after, true);
    } else if (seen(before) != Sign::kNegative) {
      tangents[0] = sum.end(before, false);
    } else {
      return Repair::met(inner.features());
    }
  }
  enter(p, sum, tangents);
  return Repair::changed(kChange);
}

// All edges that the point sees lie on at most two lines, which meet where it is.
std::optional<Features> InnerTangents::touch(PairId p, When when) {
  const SumBoundary sum = pairs_.boundary(p);
  const auto sign = [this, when](const Query& query) { return pairs_.kernel().sign(query, when); };
  const Tangents& tangents = tangents_[p];
  const auto is_on_line = [&](const Edge& edge) { return sign(sum.beyond(edge)) == Sign::kZero; };
  if (!is_on_line(beside(sum, tangents[1], false))) return std::nullopt;
  Touch at_first = tangents[0];
  // Two edges lie on one line if they are parallel.
  for (int i = 0; i < 4; ++i) {
    const Edge edge = beside(sum, at_first, true);
    if (!is_on_line(edge)) break;
    if (sign(sum.past(edge, false)) != Sign::kNegative &&
        sign(sum.short_of(edge, true)) != Sign::kNegative) {
      return edge.features();
    }
    at_first = sum.end(edge, true);
  }
  return std::nullopt;
}

std::optional<InnerTangents::Tangents> InnerTangents::tangents(ObjectId a, ObjectId b) const {
  const PairId p = pairs_.find(a, b);
  if (p == kNoPair || !pairs_[p].is_apart()) return std::nullopt;
  return tangents_[p];
}

}  // namespace kinex
