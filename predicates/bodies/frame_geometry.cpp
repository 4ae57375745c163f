// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/frame_geometry.h"

#include <algorithm>
#include <array>
#include <utility>

namespace kinex {
namespace {

// Divides three numbers by their greatest common divisor.
void make_primitive(Integer& a, Integer& b, Integer& c) {
  const Integer g = gcd(gcd(a, b), c);
  if (g.is_zero() || g == Integer(1)) return;
  a.divide_exactly(g);
  b.divide_exactly(g);
  c.divide_exactly(g);
}

// Long integers of a homogeneous triple are scaled by the power of two that leaves the largest just
// below 1: products of several would overflow doubles.
std::vector<Rational> near_one(const std::array<Integer, 3>& triple) {
  constexpr std::size_t kLong = 64;
  std::size_t bits = 0;
  for (const Integer& i : triple) bits = std::max(bits, i.bit_length());
  const Rational scale =
      bits > kLong ? Rational(Integer(1), Integer::power_of_two(bits)) : Rational(1);
  std::vector<Rational> scaled;
  for (const Integer& i : triple) scaled.push_back(Rational(i) * scale);
  return scaled;
}

Sign sign_of(const Integer& i) {
  return i.sign() > 0 ? Sign::kPositive : i.sign() < 0 ? Sign::kNegative : Sign::kZero;
}

}  // namespace

std::string FramePoint::to_string() const {
  return "(" + Rational(x, w).to_string() + ", " + Rational(y, w).to_string() + ")";
}

std::vector<Rational> FramePoint::coordinates() const { return near_one({x, y, w}); }

std::string FrameLine::to_string() const {
  return "[" + nx.to_string() + ", " + ny.to_string() + " | " + h.to_string() + "]";
}

std::vector<Rational> FrameLine::coordinates() const { return near_one({nx, ny, h}); }

FramePoint frame_point(const Rational& x, const Rational& y) {
  const Integer w = lcm(x.denominator(), y.denominator());
  FramePoint p{(x * Rational(w)).numerator(), (y * Rational(w)).numerator(), w};
  make_primitive(p.x, p.y, p.w);
  return p;
}

FrameLine frame_line(const Rational& nx, const Rational& ny, const FramePoint& through) {
  return frame_line(nx, ny,
                    (nx * Rational(through.x) + ny * Rational(through.y)) / Rational(through.w));
}

FrameLine frame_line(const Rational& nx, const Rational& ny, const Rational& h) {
  const Rational scale(lcm(lcm(nx.denominator(), ny.denominator()), h.denominator()));
  FrameLine line{(nx * scale).numerator(), (ny * scale).numerator(), (h * scale).numerator()};
  make_primitive(line.nx, line.ny, line.h);
  return line;
}

FramePoint meeting(const FrameLine& first, const FrameLine& second) {
  FramePoint p{first.h * second.ny - second.h * first.ny, first.nx * second.h - second.nx * first.h,
               first.nx * second.ny - second.nx * first.ny};
  make_primitive(p.x, p.y, p.w);
  return p;
}

Sign side(const FrameLine& line, const FramePoint& p) {
  return sign_of(line.nx * p.x + line.ny * p.y - line.h * p.w);
}

Sign turn(const FrameLine& first, const FrameLine& second) {
  return sign_of(first.nx * second.ny - second.nx * first.ny);
}

int quadrant(const FrameLine& line) {
  if (line.nx.sign() > 0 && line.ny.sign() >= 0) return 0;
  if (line.nx.sign() <= 0 && line.ny.sign() > 0) return 1;
  if (line.nx.sign() < 0) return 2;
  return 3;
}

FramePolygon frame_polygon(const std::vector<Vertex2>& polygon, bool negated) {
  FramePolygon result;
  for (const Vertex2& v : polygon) {
    result.vertices.push_back(negated ? frame_point(-v[0], -v[1]) : frame_point(v[0], v[1]));
  }
  const std::size_t n = result.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const FramePoint& p = result.vertices[i];
    const FramePoint& q = result.vertices[(i + 1) % n];
    const Rational dx = Rational(q.x, q.w) - Rational(p.x, p.w);
    const Rational dy = Rational(q.y, q.w) - Rational(p.y, p.w);
    result.edges.push_back(frame_line(dy, -dx, p));
  }
  const auto before = [](const FrameLine& a, const FrameLine& b) {
    const int qa = quadrant(a), qb = quadrant(b);
    return qa != qb ? qa < qb : turn(a, b) == Sign::kPositive;
  };
  const auto first = std::min_element(result.edges.begin(), result.edges.end(), before);
  const auto shift = first - result.edges.begin();
  std::rotate(result.edges.begin(), first, result.edges.end());
  std::rotate(result.vertices.begin(), result.vertices.begin() + shift, result.vertices.end());
  return result;
}

Rational root_above(const Rational& q) {
  if (q.sign() <= 0) return Rational();
  // sqrt(n / d) = sqrt(n d 4^k) / (d 2^k); eight bits of the root are enough.
  Integer square = q.numerator() * q.denominator();
  const std::size_t bits = square.bit_length();
  const unsigned long k = bits < 18 ? (18 - bits) / 2 + 1 : 0;
  square <<= 2 * k;
  Integer root;
  mpz_sqrt(root.raw(), square.raw());
  return Rational(root + Integer(1), q.denominator() << k);
}

}  // namespace kinex
