// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/collision/polygons.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "experiments/formats/angles.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

constexpr unsigned long kVertexBits = 40;  // of the tangents of half angles

Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

Coefficients sum(const Coefficients& a, const Coefficients& b, int sign) {
  Coefficients result(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < a.size(); ++i) result[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) result[i] += Rational(sign) * b[i];
  return result;
}

Trajectory trajectory_of(Coefficients x, Coefficients y, Coefficients p, Coefficients q) {
  Trajectory trajectory{{std::move(x), std::move(y), std::move(p), std::move(q)}};
  trajectory.normalise();
  return trajectory;
}

}  // namespace

std::vector<Vertex2> regular_polygon(int n, const Rational& radius) {
  std::vector<Vertex2> polygon;
  polygon.reserve(static_cast<std::size_t>(n));
  for (std::int64_t k = 0; k < n; ++k) {
    const std::int64_t quadrant = 4 * k / n;
    const Rational half =
        formats::approximate_pi() * lab::fraction(4 * k - quadrant * n, 4 * std::int64_t{n});
    const formats::CosSin turn = formats::approximate_cos_sin(half);
    const Rational u = formats::rounded(turn.sin / turn.cos, kVertexBits);
    const Rational scale = radius / (Rational(1) + u * u);
    Rational x = scale * (Rational(1) - u * u), y = scale * Rational(2) * u;
    for (std::int64_t i = 0; i < quadrant; ++i) {
      Rational next = -y;
      y = std::move(x);
      x = std::move(next);
    }
    polygon.push_back({std::move(x), std::move(y)});
  }
  return polygon;
}

Rational top_of(const std::vector<Vertex2>& polygon) {
  Rational top = polygon.front()[1];
  for (const Vertex2& vertex : polygon) top = std::max(top, vertex[1]);
  return top;
}

// With u = t count / span - h: (1 - u) + iu turns by 90 degrees while u runs through [0, 1]; the
// next piece is that times i. A third would be the first again, up to the factor -1.
std::vector<RotorPiece> half_turns(int count, const Rational& span) {
  const Rational rate = Rational(count) / span;
  std::vector<RotorPiece> pieces;
  for (int h = 0; h < count; ++h) {
    RotorPiece piece;
    if (h > 0) piece.from = Rational(h) / rate;
    if (h + 1 < count) piece.to = Rational(h + 1) / rate;
    const Coefficients u{Rational(-h), rate}, rest{Rational(1 + h), -rate};
    piece.p = h % 2 == 0 ? rest : Coefficients{Rational(h), -rate};
    piece.q = h % 2 == 0 ? u : rest;
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<RotorPiece> composed(const std::vector<RotorPiece>& fine,
                                 const std::vector<RotorPiece>& coarse) {
  std::vector<RotorPiece> result;
  std::size_t k = 0;
  for (const RotorPiece& f : fine) {
    while (f.from && coarse[k].to && *coarse[k].to <= *f.from) ++k;
    const RotorPiece& c = coarse[k];
    result.push_back({f.from, f.to, sum(product(f.p, c.p), product(f.q, c.q), -1),
                      sum(product(f.p, c.q), product(f.q, c.p), 1)});
  }
  return result;
}

void add_turning_body(Scene& scene, std::string id, std::vector<Vertex2> polygon, const Rational& x,
                      const Rational& y, const std::vector<RotorPiece>& rotor) {
  Motion motion;
  for (const RotorPiece& piece : rotor) {
    motion.pieces.push_back({piece.from, piece.to, trajectory_of({x}, {y}, piece.p, piece.q)});
  }
  scene.objects.push_back({std::move(id), std::move(motion), std::move(polygon)});
}

void add_body(Scene& scene, std::string id, std::vector<Vertex2> polygon, Coefficients x,
              Coefficients y, Coefficients p, Coefficients q) {
  Motion motion;
  motion.pieces.push_back({std::nullopt, std::nullopt,
                           trajectory_of(std::move(x), std::move(y), std::move(p), std::move(q))});
  scene.objects.push_back({std::move(id), std::move(motion), std::move(polygon)});
}

void add_body_on_polyline(Scene& scene, std::string id, std::vector<Vertex2> polygon,
                          const std::vector<Vertex2>& points) {
  Motion motion;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Rational t(static_cast<std::int64_t>(i));
    std::array<Coefficients, 2> line;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Rational way = points[i + 1][axis] - points[i][axis];
      line[axis] = {points[i][axis] - way * t, way};
    }
    MotionPiece piece{std::nullopt, std::nullopt, trajectory_of(line[0], line[1], {1}, {0})};
    if (i > 0) piece.from = t;
    if (i + 2 < points.size()) piece.to = t + Rational(1);
    motion.pieces.push_back(std::move(piece));
  }
  scene.objects.push_back({std::move(id), std::move(motion), std::move(polygon)});
}

}  // namespace kinex::families
