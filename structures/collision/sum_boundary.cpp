// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/sum_boundary.h"

namespace kinex {

bool SumBoundary::before(std::uint8_t z, Id e, Id f) const {
  const Sign s = sign(order_before(z, e, f));
  return s == Sign::kPositive || (s == Sign::kZero && z == 0);
}

SumBoundary::Edge SumBoundary::beside(Id x, Id y, bool forward) const {
  const Id e = forward ? x : frame(0).before(x), f = forward ? y : frame(1).before(y);
  if (before(0, e, f) == forward) return {0, e, y};
  return {1, f, x};
}

std::array<SumBoundary::Id, 2> SumBoundary::end(const Edge& edge, bool last) const {
  const Id own = last ? frame(edge.z).after(edge.edge) : edge.edge;
  if (edge.z == 0) return {own, edge.vertex};
  return {edge.vertex, own};
}

std::vector<SumBoundary::Edge> SumBoundary::edges() const {
  const Id n = frame(0).size(), m = frame(1).size();
  // The vertex of B' whose cone holds the normal of A's first edge.
  Id y = 0;
  while (y + 1 < m && !(!before(0, 0, frame(1).before(y)) && before(0, 0, y))) ++y;
  std::vector<Edge> result;
  result.reserve(n + m);
  result.push_back({0, 0, y});
  Id x = 1 % n, edges_of_a = 1, edges_of_b = 0;
  while (edges_of_a < n || edges_of_b < m) {
    const bool from_a = edges_of_b == m || (edges_of_a < n && before(0, x, y));
    if (from_a) {
      result.push_back({0, x, y});
      x = frame(0).after(x);
      ++edges_of_a;
    } else {
      result.push_back({1, y, x});
      y = frame(1).after(y);
      ++edges_of_b;
    }
  }
  return result;
}

}  // namespace kinex
