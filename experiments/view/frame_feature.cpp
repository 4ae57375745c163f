// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/frame_feature.h"

#include <cstddef>

namespace kinex::view {

namespace {

using Kind = FrameFeature::Kind;
using Vector = std::array<Rational, 2>;

Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; }
Rational cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1]}; }

std::vector<Vector> turned(const std::vector<Vertex2>& polygon, bool negated) {
  if (!negated) return polygon;
  std::vector<Vector> result;
  for (const Vector& v : polygon) result.push_back({-v[0], -v[1]});
  return result;
}

std::uint32_t place(std::size_t i) { return static_cast<std::uint32_t>(i); }

// The farthest vertices in a direction: one, or two that follow each other.
struct Farthest {
  Rational height;
  std::uint32_t first = 0, last = 0;
};
Farthest farthest(const std::vector<Vector>& vertices, const Vector& direction) {
  Farthest best{dot(vertices[0], direction), 0, 0};
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const Rational height = dot(vertices[i], direction);
    if (height == best.height) best.last = place(i);
    if (best.height < height) best = {height, place(i), place(i)};
  }
  // The last vertex and the first: the edge begins at the last.
  if (best.first == 0 && best.last > 1) best = {best.height, best.last, 0};
  return best;
}

}  // namespace

FrameFeature support_feature(const std::vector<Vertex2>& polygon, bool negated,
                             const std::array<Rational, 2>& direction) {
  const Farthest found = farthest(turned(polygon, negated), direction);
  return {Kind::kSupport, found.first, found.last};
}

FrameFeature line_feature(const std::vector<Vertex2>& polygon, bool negated,
                          const std::vector<Rational>& line) {
  const std::vector<Vector> vertices = turned(polygon, negated);
  const Vector normal{line[0], line[1]};
  const Farthest found = farthest(vertices, normal);
  if (found.height == line[2]) {
    const bool edge = found.first != found.last;
    return {edge ? Kind::kEdge : Kind::kVertex, found.first, edge ? found.first : found.last};
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::size_t next = i + 1 == vertices.size() ? 0 : i + 1;
    const Vector along = minus(vertices[next], vertices[i]);
    if (!cross(normal, along).is_zero() || dot(normal, along) < Rational(0)) continue;
    for (const std::size_t end : {i, next}) {
      if (dot(vertices[end], normal) == line[2]) return {Kind::kAcross, place(i), place(end)};
    }
  }
  return {Kind::kSupport, found.first, found.last};
}

FrameFeature point_feature(const std::vector<Vertex2>& polygon, bool negated,
                           const std::vector<Rational>& point) {
  const std::vector<Vector> vertices = turned(polygon, negated);
  const Vector p{point[0] / point[2], point[1] / point[2]};
  const std::size_t n = vertices.size();
  std::vector<bool> sees(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (vertices[i] == p) return {Kind::kVertex, place(i), place(i)};
    const Vector along = minus(vertices[i + 1 == n ? 0 : i + 1], vertices[i]);
    sees[i] = cross(along, minus(p, vertices[i])) < Rational(0);
  }
  // The edges that it sees follow each other.
  for (std::size_t i = 0; i < n; ++i) {
    if (!sees[i] || sees[i == 0 ? n - 1 : i - 1]) continue;
    std::size_t last = i;
    while (sees[last]) last = last + 1 == n ? 0 : last + 1;
    return {Kind::kCorner, place(i), place(last)};
  }
  return {};
}

}  // namespace kinex::view
