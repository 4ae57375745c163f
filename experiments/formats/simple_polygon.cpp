// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/simple_polygon.h"

#include <algorithm>

namespace kinex::formats {

namespace {

constexpr std::size_t kMostPairs = 1000000;

// An edge and the box about it.
struct Edge {
  std::size_t number;
  Vertex2 from, to;
  std::array<Rational, 2> low, high;
};

// The side of the line from `a` to `b` on which `c` lies: +1 left.
int side(const Vertex2& a, const Vertex2& b, const Vertex2& c) {
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign();
}

// Segments whose boxes meet intersect iff neither has both of the other's ends on one side.
bool meet(const Edge& e, const Edge& f) {
  if (e.high[1] < f.low[1] || f.high[1] < e.low[1]) return false;
  return side(e.from, e.to, f.from) * side(e.from, e.to, f.to) <= 0 &&
         side(f.from, f.to, e.from) * side(f.from, f.to, e.to) <= 0;
}

}  // namespace

std::optional<std::array<std::size_t, 2>> edges_that_meet(const std::vector<Vertex2>& polygon) {
  const std::size_t n = polygon.size();
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < n; ++k) {
    const Vertex2 &from = polygon[k], &to = polygon[(k + 1) % n];
    Edge edge{k, from, to, {}, {}};
    for (const std::size_t axis : {0, 1}) {
      edge.low[axis] = std::min(from[axis], to[axis]);
      edge.high[axis] = std::max(from[axis], to[axis]);
    }
    edges.push_back(std::move(edge));
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) {
    return e.low[0] != f.low[0] ? e.low[0] < f.low[0] : e.number < f.number;
  });
  std::vector<const Edge*> open;  // their boxes reach the sweep line
  std::size_t pairs = 0;
  for (const Edge& edge : edges) {
    std::erase_if(open, [&](const Edge* other) { return other->high[0] < edge.low[0]; });
    for (const Edge* other : open) {
      if (++pairs > kMostPairs) return std::nullopt;
      const auto [first, second] = std::minmax(edge.number, other->number);
      if (second - first == 1 || second - first == n - 1) continue;
      if (meet(edge, *other)) return std::array<std::size_t, 2>{first, second};
    }
    open.push_back(&edge);
  }
  return std::nullopt;
}

}  // namespace kinex::formats
