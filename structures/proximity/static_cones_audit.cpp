// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/static_cones_audit.h"

#include <cstddef>
#include <cstdlib>

namespace kinex {
namespace {

using Vector = std::array<Rational, 2>;

// The cone is where the products with both sides are positive, and the smallest length comes first; of
// equal ones the length after the turn decides, then the id along (2, 1), up or down.
struct Cone {
  Vector one, other;  // sides
  Vector along;       // the length: the product with it
};

Vector opposite(const Vector& v) { return {-v[0], -v[1]}; }

Rational product(const Vector& v, const Rational& x, const Rational& y) {
  return v[0] * x + v[1] * y;
}

// The corners of the unit circle on a half of it and the one after it, counter-clockwise.
std::vector<Vector> half_circle(int corners) {
  std::vector<Vector> half;
  const auto add = [&half](int numerator, int denominator) {  // the tangent of half the angle
    const Rational q{Integer(numerator), Integer(denominator)};
    const Rational square = q * q, length = Rational(1) + square;
    half.push_back({(Rational(1) - square) / length, (q + q) / length});
  };
  add(0, 1);
  if (corners == 20) add(1, 5);
  add(1, 3);
  add(1, 2);
  if (corners == 20) add(2, 3);
  const std::size_t quarter = half.size();
  for (std::size_t i = 0; i <= quarter; ++i) {
    const Vector last = half[i];
    half.push_back({-last[1], last[0]});
  }
  return half;
}

// Between neighbouring corners: the linear function that is 1 at both.
Vector unit_between(const Vector& b, const Vector& c) {
  const Rational determinant = b[0] * c[1] - b[1] * c[0];
  return {(c[1] - b[1]) / determinant, (b[0] - c[0]) / determinant};
}

Vector vector(int x, int y) { return {Rational(x), Rational(y)}; }

// -K2, K1, and the quadrant of both of the opposite octants; -K4, K3, and theirs.
std::vector<Cone> octants() {
  return {{vector(-1, 0), vector(1, -1), vector(0, -1)}, {vector(0, 1), vector(1, -1), vector(1, 0)},
          {vector(-1, 0), vector(0, 1), vector(-1, 1)},  {vector(0, -1), vector(1, 1), vector(1, 0)},
          {vector(-1, 0), vector(1, 1), vector(0, 1)},   {vector(-1, 0), vector(0, -1), vector(-1, -1)}};
}

// Each cone between two corners, and two wide ones that complete the figure.
std::vector<Cone> cones_of(int corners) {
  if (corners == 4) return octants();
  const std::vector<Vector> half = half_circle(corners);
  std::vector<Cone> result;
  for (std::size_t i = 0; i + 1 < half.size(); ++i) {
    const Vector &b = half[i], &c = half[i + 1], u = unit_between(b, c);
    const Vector left{-b[1], b[0]}, right{c[1], -c[0]};
    result.push_back({left, right, u});
    result.push_back({right, opposite(u), opposite(left)});
    result.push_back({opposite(u), left, opposite(right)});
  }
  return result;
}

// On which side of a point other points are, by vectors: the signs of the products of a vector with the
// steps between all points. Of two opposite vectors one is kept.
class Sides {
 public:
  explicit Sides(const Snapshot& snapshot) : snapshot_(&snapshot) {}

  // The number of a vector, negative for the opposite of one.
  int number(const Vector& v) {
    for (std::size_t i = 0; i < vectors_.size(); ++i) {
      if (vectors_[i] == v) return static_cast<int>(i) + 1;
      if (vectors_[i] == opposite(v)) return -static_cast<int>(i) - 1;
    }
    vectors_.push_back(v);
    signs_.emplace_back();
    const auto n = static_cast<ObjectId>(snapshot_->objects());
    for (ObjectId p = 0; p < n; ++p) {
      for (ObjectId q = 0; q < n; ++q) {
        signs_.back().push_back(p < q ? sign(v, p, q) : p == q ? 0 : -signs_.back()[q * n + p]);
      }
    }
    return static_cast<int>(vectors_.size());
  }
  int side(int number, ObjectId p, ObjectId q) const {
    const auto& signs = signs_[static_cast<std::size_t>(std::abs(number)) - 1];
    const int sign = signs[p * snapshot_->objects() + q];
    return number > 0 ? sign : -sign;
  }

 private:
  // Of the step from p to q, p < q.
  int sign(const Vector& v, ObjectId p, ObjectId q) const {
    const Snapshot& s = *snapshot_;
    if (!s.alive(p) || !s.alive(q)) return 0;
    const Rational x = s.position(q, 0) - s.position(p, 0), y = s.position(q, 1) - s.position(p, 1);
    for (const Rational& value : {product(v, x, y), product(v, -y, x)}) {
      if (!value.is_zero()) return value.sign();
    }
    return product(v, Rational(2), Rational(1)).sign();
  }

  const Snapshot* snapshot_;
  std::vector<Vector> vectors_;
  std::vector<std::vector<int>> signs_;  // by vector, then from one point to another
};

}  // namespace

std::vector<Vector> static_units(int corners) {
  if (corners == 4) return {vector(1, 0), vector(0, 1)};
  const std::vector<Vector> half = half_circle(corners);
  std::vector<Vector> result;
  for (std::size_t i = 0; i + 1 < half.size(); ++i) {
    result.push_back(unit_between(half[i], half[i + 1]));
  }
  return result;
}

std::vector<std::vector<ObjectId>> static_cones(const Snapshot& snapshot, int corners) {
  const std::vector<Cone> cones = cones_of(corners);
  std::vector<std::vector<ObjectId>> result(snapshot.objects(),
                                            std::vector<ObjectId>(cones.size(), kNoObject));
  Sides sides(snapshot);
  for (std::size_t i = 0; i < cones.size(); ++i) {
    const int one = sides.number(cones[i].one), other = sides.number(cones[i].other),
              along = sides.number(cones[i].along);
    for (ObjectId p = 0; p < snapshot.objects(); ++p) {
      for (ObjectId q = 0; q < snapshot.objects(); ++q) {
        if (sides.side(one, p, q) <= 0 || sides.side(other, p, q) <= 0) continue;
        ObjectId& best = result[p][i];
        if (best == kNoObject || sides.side(along, best, q) < 0) best = q;
      }
    }
  }
  return result;
}

}  // namespace kinex
