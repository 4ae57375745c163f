// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/closest_features.h"

namespace kinex {

// Slots of a vertex and an edge:
//   0  past the edge's first end
//   1  short of its last end
//   2  after the edge before the vertex
//   3  before the edge after the vertex
//   4  outside
// Slots of two vertices, for A (0, 1) and then for B' (2, 3): short of the vertex in the direction
// of the edge after it; past it in that of the edge before it.
Query ClosestFeatures::claim(const SumBoundary& sum, const State& state, std::uint32_t slot) {
  if (state.edge) {
    const std::uint8_t z = state.z, w = SumBoundary::other(z);
    switch (slot) {
      case 0:
        return sum.past(z, state.e, false, state.v);
      case 1:
        return sum.short_of(z, state.e, true, state.v);
      case 2:
        return sum.order_after(z, state.e, sum.frame(w).before(state.v));
      case 3:
        return sum.order_before(z, state.e, state.v);
      default:
        return sum.at_touch(sum.beyond(z, state.e, state.v));
    }
  }
  const std::uint32_t x = state.e, y = state.v;
  switch (slot) {
    // A point may stay on the line of one of these: where it reaches the vertex the other touches.
    case 0:
      return sum.at_touch(sum.short_of(0, x, false, y));
    case 1:
      return sum.at_touch(sum.past(0, sum.frame(0).before(x), true, y));
    case 2:
      return sum.short_of(1, y, false, x);
    default:
      return sum.past(1, sum.frame(1).before(y), true, x);
  }
}

void ClosestFeatures::enter(PairId p, const SumBoundary& sum, const State& state) {
  state_[p] = state;
  std::array<Query, 6> queries;
  std::uint32_t count = 0;
  for (const std::uint32_t own = state.edge ? 5 : 4; count < own; ++count) {
    queries[count] = claim(sum, state, count);
  }
  if (watch_discs_) queries[count++] = pairs_.volumes().discs_overlap(pairs_[p].a, pairs_[p].b);
  pairs_.set(p, slots_, {queries.data(), count});
}

bool ClosestFeatures::start(PairId p, const Edge*) {
  if (state_.size() <= p) state_.resize(p + std::size_t{1});
  const SumBoundary sum = pairs_.boundary(p);
  for (const Edge& edge : sum.edges()) {
    // This edge of M, or the vertex of M at its last end.
    if (sum.holds(sum.beyond(edge)) && sum.holds(sum.past(edge, false)) &&
        sum.holds(sum.short_of(edge, true))) {
      enter(p, sum, {true, edge.z, edge.edge, edge.vertex});
      return true;
    }
    const auto [x, y] = sum.end(edge, true);
    if (sum.holds(sum.past(0, sum.frame(0).before(x), true, y)) &&
        sum.holds(sum.short_of(0, x, false, y)) &&
        sum.holds(sum.past(1, sum.frame(1).before(y), true, x)) &&
        sum.holds(sum.short_of(1, y, false, x))) {
      enter(p, sum, {false, 0, x, y});
      return true;
    }
  }
  return false;
}

// The successor of a vertex and an edge.
ClosestFeatures::State ClosestFeatures::next(const SumBoundary& sum, const State& state,
                                             std::uint32_t slot) const {
  const std::uint8_t z = state.z, w = SumBoundary::other(z);
  const auto vertices = [z](std::uint32_t own, std::uint32_t other) {
    return State{false, 0, z == 0 ? own : other, z == 0 ? other : own};
  };
  if (slot == 0) return vertices(state.e, state.v);
  if (slot == 1) return vertices(sum.frame(z).after(state.e), state.v);
  // The edge is parallel to one at the vertex: the other end of that one takes over if it projects
  // into the edge; otherwise the edge's end that projects into that one.
  const bool back = slot == 2;
  const std::uint32_t g = back ? sum.frame(w).before(state.v) : state.v;
  const std::uint32_t v = back ? g : sum.frame(w).after(state.v);
  if (sum.sign(sum.past(z, state.e, false, v)) == Sign::kNegative) return {true, w, g, state.e};
  if (sum.sign(sum.short_of(z, state.e, true, v)) == Sign::kNegative) {
    return {true, w, g, sum.frame(z).after(state.e)};
  }
  return {true, z, state.e, v};
}

SeparationProof::Repair ClosestFeatures::repair(PairId p, std::uint32_t slot) {
  const SumBoundary sum = pairs_.boundary(p);
  const State state = state_[p];
  // The vertex has crossed the edge's line: beside the edge, if another certificate fails too.
  for (std::uint32_t i = 0; is_contact_slot(p, slot) && i < 4; ++i) {
    if (sum.sign(claim(sum, state, i)) == Sign::kNegative) slot = i;
  }
  // The point stays at an end of the edge: it may slide along the next edge of M.
  for (std::uint32_t i = 0; is_contact_slot(p, slot) && i < 2; ++i) {
    if (sum.sign(claim(sum, state, i)) != Sign::kZero) continue;
    const bool forward = i == 1;
    const std::uint32_t own = forward ? sum.frame(state.z).after(state.e) : state.e;
    const Edge next =
        state.z == 0 ? sum.beside(own, state.v, forward) : sum.beside(state.v, own, forward);
    if (sum.holds(sum.beyond(next))) slot = i;
  }
  if (is_contact_slot(p, slot)) return Repair::met(state.as_edge().features());
  State to;
  if (state.edge) {
    to = next(sum, state, slot);
  } else {
    // To the edge of M after the vertex (slots 0 and 2) or before it. The normal cone of a vertex
    // meets M in that vertex only: where several certificates fail the point may be there, and move
    // into M, or out beyond the other edge.
    bool forward = slot % 2 == 0;
    Edge edge = sum.beside(state.e, state.v, forward);
    const Sign at_edge = sum.sign(sum.beyond(edge));
    // Of two edges on one line, a point that slides takes the one that it is on.
    if (at_edge == Sign::kNegative || (at_edge == Sign::kZero && !sum.is_along(edge, forward))) {
      forward = !forward;
      const Edge other = sum.beside(state.e, state.v, forward);
      if (sum.holds(sum.beyond(other))) {
        if (at_edge == Sign::kNegative || sum.is_along(other, forward)) edge = other;
      } else if (at_edge == Sign::kNegative) {
        return Repair::met(edge.features());
      }
    }
    to = {true, edge.z, edge.edge, edge.vertex};
  }
  enter(p, sum, to);
  return Repair::changed(kChange);
}

// At a vertex of M all four certificates are zero; along edges of A that meet only there, two.
std::optional<Features> ClosestFeatures::touch(PairId p, When when) {
  const SumBoundary sum = pairs_.boundary(p);
  const State& state = state_[p];
  const auto is_zero = [&](std::uint32_t slot) {
    return pairs_.kernel().sign(claim(sum, state, slot), when) == Sign::kZero;
  };
  if (state.edge) {
    if (!is_zero(4)) return std::nullopt;
    return state.as_edge().features();
  }
  if (!is_zero(0) || !is_zero(1)) return std::nullopt;
  return sum.beside(state.e, state.v, true).features();
}

}  // namespace kinex
