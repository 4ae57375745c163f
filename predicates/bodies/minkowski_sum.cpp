// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/minkowski_sum.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace kinex {
namespace {

// p / q where p is a constant multiple of q, which is not zero; nullopt where it is not.
std::optional<Rational> constant_ratio(const std::vector<Rational>& p,
                                       const std::vector<Rational>& q) {
  std::size_t k = q.size();
  while (k > 0 && q[k - 1].is_zero()) --k;
  const Rational ratio = k <= p.size() ? p[k - 1] / q[k - 1] : Rational();
  for (std::size_t i = 0; i < std::max(p.size(), q.size()); ++i) {
    const Rational left = i < p.size() ? p[i] : Rational();
    const Rational right = i < q.size() ? q[i] : Rational();
    if (left != ratio * right) return std::nullopt;
  }
  return ratio;
}

bool before(const FrameLine& a, const FrameLine& b) {
  const int qa = quadrant(a), qb = quadrant(b);
  return qa != qb ? qa < qb : turn(a, b) == Sign::kPositive;
}

// B' turned, with the numbers of its vertices before; edges ascend by angle from 0.
struct Turned {
  FramePolygon polygon;
  std::uint32_t shift;
};
Turned turned(const FramePolygon& b, const Rational& c, const Rational& s) {
  Turned result{{}, 0};
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) {
    const FramePoint& p = b.vertices[i];
    const FrameLine& e = b.edges[i];
    const Rational x(p.x, p.w), y(p.y, p.w), nx(e.nx), ny(e.ny);
    result.polygon.vertices.push_back(frame_point(c * x - s * y, s * x + c * y));
    result.polygon.edges.push_back(
        frame_line(c * nx - s * ny, s * nx + c * ny, result.polygon.vertices.back()));
  }
  auto& edges = result.polygon.edges;
  const auto shift = std::min_element(edges.begin(), edges.end(), before) - edges.begin();
  std::rotate(edges.begin(), edges.begin() + shift, edges.end());
  auto& vertices = result.polygon.vertices;
  std::rotate(vertices.begin(), vertices.begin() + shift, vertices.end());
  result.shift = static_cast<std::uint32_t>(shift);
  return result;
}

FramePoint plus(const FramePoint& p, const FramePoint& q) {
  return frame_point(Rational(p.x, p.w) + Rational(q.x, q.w),
                     Rational(p.y, p.w) + Rational(q.y, q.w));
}

}  // namespace

std::optional<MinkowskiSum> minkowski_sum(const FramePolygon& a, const FramePolygon& b,
                                          const Trajectory& pose) {
  const auto c = constant_ratio(pose.coordinates[5], pose.coordinates[4]);
  const auto s = constant_ratio(pose.coordinates[6], pose.coordinates[4]);
  if (!c || !s) return std::nullopt;
  const Turned other = turned(b, *c, *s);
  const FramePolygon& t = other.polygon;
  const std::uint32_t n = static_cast<std::uint32_t>(a.size());
  const std::uint32_t m = static_cast<std::uint32_t>(t.size());
  const auto number = [&](std::uint32_t j) { return (j + other.shift) % m; };

  // Both start at the edge of smallest angle, so their first vertices are the ones before it: the
  // sum's first vertex is their sum.
  MinkowskiSum sum;
  std::uint32_t i = 0, j = 0;
  while (i < n || j < m) {
    const FramePoint vertex = plus(a.vertices[i % n], t.vertices[j % m]);
    const bool parallel = i < n && j < m && quadrant(a.edges[i]) == quadrant(t.edges[j]) &&
                          turn(a.edges[i], t.edges[j]) == Sign::kZero;
    const bool from_a = j == m || (i < n && (parallel || before(a.edges[i], t.edges[j])));
    sum.polygon.vertices.push_back(vertex);
    sum.a.push_back(i % n);
    sum.b.push_back(number(j % m));
    const FrameLine& e = from_a ? a.edges[i] : t.edges[j];
    sum.polygon.edges.push_back(frame_line(Rational(e.nx), Rational(e.ny), vertex));
    if (from_a) {
      sum.edges.push_back({0, i, number(j % m)});
      ++i;
      if (parallel) ++j;
    } else {
      sum.edges.push_back({1, number(j), i % n});
      ++j;
    }
  }
  return sum;
}

}  // namespace kinex
