// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/placed_body.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace kinex::formats {

namespace {

// The outward normal of the edge from vertex k, and the edge's height in its direction.
struct EdgeLine {
  Rational nx, ny, height;
};

EdgeLine edge_line(const Polygon2& p, std::size_t k) {
  const Vertex2& a = p[k];
  const Vertex2& b = p[(k + 1) % p.size()];
  EdgeLine line{b[1] - a[1], a[0] - b[0], {}};
  line.height = line.nx * a[0] + line.ny * a[1];
  return line;
}

Rational height(const EdgeLine& line, const Vertex2& v) { return line.nx * v[0] + line.ny * v[1]; }

// The sign of the gap between the line of edge k of `a` and `b`: > 0 if the line separates
// strictly. `lowest` is a vertex of b to walk from counter-clockwise to the lowest one; nullopt:
// looks at all.
int gap_sign(const Polygon2& a, std::size_t k, const Polygon2& b,
             std::optional<std::size_t>& lowest) {
  const EdgeLine line = edge_line(a, k);
  if (!lowest) {
    lowest = 0;
    Rational least = height(line, b[0]);
    for (std::size_t i = 1; i < b.size(); ++i) {
      Rational h = height(line, b[i]);
      if (h < least) {
        least = std::move(h);
        lowest = i;
      }
    }
    return (least - line.height).sign();
  }
  // The normal has turned counter-clockwise by less than half a turn since the last edge.
  Rational least = height(line, b[*lowest]);
  for (;;) {
    const std::size_t next = (*lowest + 1) % b.size();
    Rational h = height(line, b[next]);
    if (!(h < least)) break;
    least = std::move(h);
    lowest = next;
  }
  return (least - line.height).sign();
}

using Approximate = std::vector<std::array<double, 2>>;

Approximate approximate(const Polygon2& p) {
  Approximate result;
  result.reserve(p.size());
  for (const Vertex2& v : p) result.push_back({v[0].to_double(), v[1].to_double()});
  return result;
}

struct Guess {
  std::size_t edge = 0;
  double gap = -std::numeric_limits<double>::infinity();
};

// The edge of `a` whose line has the largest gap to `b`, approximately.
Guess best_edge(const Approximate& a, const Approximate& b) {
  Guess best;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const auto& p = a[k];
    const auto& q = a[(k + 1) % a.size()];
    const double nx = q[1] - p[1], ny = p[0] - q[0];
    double least = std::numeric_limits<double>::infinity();
    for (const auto& v : b) least = std::min(least, nx * (v[0] - p[0]) + ny * (v[1] - p[1]));
    const double length = nx * nx + ny * ny;
    const double gap = least < 0 ? -least * least / length : least * least / length;
    if (gap > best.gap) best = {k, gap};
  }
  return best;
}

// The largest sign of a gap over the edges of `a`.
int best_gap_sign(const Polygon2& a, const Polygon2& b) {
  std::optional<std::size_t> lowest;
  int best = -1;
  for (std::size_t k = 0; k < a.size() && best < 1; ++k) {
    best = std::max(best, gap_sign(a, k, b, lowest));
  }
  return best;
}

Rational squared_distance(const Vertex2& v, const Vertex2& a, const Vertex2& b) {
  const Rational ex = b[0] - a[0], ey = b[1] - a[1];
  const Rational dx = v[0] - a[0], dy = v[1] - a[1];
  const Rational along = ex * dx + ey * dy;
  const Rational length = ex * ex + ey * ey;
  if (along.sign() <= 0) return dx * dx + dy * dy;
  if (along >= length) {
    const Rational fx = v[0] - b[0], fy = v[1] - b[1];
    return fx * fx + fy * fy;
  }
  const Rational across = ex * dy - ey * dx;
  return across * across / length;
}

}  // namespace

Polygon2 placed_polygon(const Polygon2& polygon, const Trajectory& trajectory, const Rational& t) {
  const Rational x = trajectory.position(0, t), y = trajectory.position(1, t);
  const Rational p = trajectory.position(2, t), q = trajectory.position(3, t);
  const Rational n = p * p + q * q;
  const Rational c = (p * p - q * q) / n, s = Rational(2) * p * q / n;
  Polygon2 placed;
  placed.reserve(polygon.size());
  for (const Vertex2& v : polygon) {
    placed.push_back({x + c * v[0] - s * v[1], y + s * v[0] + c * v[1]});
  }
  return placed;
}

Contact contact_of(const Polygon2& a, const Polygon2& b) {
  const Approximate near_a = approximate(a), near_b = approximate(b);
  const Guess of_a = best_edge(near_a, near_b), of_b = best_edge(near_b, near_a);
  std::optional<std::size_t> lowest;
  const int guess =
      of_a.gap >= of_b.gap ? gap_sign(a, of_a.edge, b, lowest) : gap_sign(b, of_b.edge, a, lowest);
  if (guess > 0) return Contact::kApart;
  const int best = std::max(best_gap_sign(a, b), best_gap_sign(b, a));
  if (best > 0) return Contact::kApart;
  return best == 0 ? Contact::kTouching : Contact::kOverlapping;
}

Rational squared_distance(const Polygon2& a, const Polygon2& b) {
  if (contact_of(a, b) != Contact::kApart) return 0;
  std::optional<Rational> least;
  const auto visit = [&](const Polygon2& vertices, const Polygon2& edges) {
    for (const Vertex2& v : vertices) {
      for (std::size_t k = 0; k < edges.size(); ++k) {
        Rational d = squared_distance(v, edges[k], edges[(k + 1) % edges.size()]);
        if (!least || d < *least) least = std::move(d);
      }
    }
  };
  visit(a, b);
  visit(b, a);
  return *least;
}

}  // namespace kinex::formats
