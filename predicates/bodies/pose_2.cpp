// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/pose_2.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/numbers/check.h"
#include "core/numbers/dyadic_polynomial.h"
#include "core/numbers/integer.h"
#include "core/numbers/rational.h"

namespace kinex {
namespace {

// Integers over a denominator > 0 that all coefficients share.
struct Fractions {
  std::vector<Integer> c;
  Integer denominator = Integer(1);
};

Fractions fractions(const std::vector<Rational>& coefficients) {
  Fractions f;
  for (const Rational& q : coefficients) f.denominator = lcm(f.denominator, q.denominator());
  for (const Rational& q : coefficients) {
    Integer factor = f.denominator;
    factor.divide_exactly(q.denominator());
    f.c.push_back(q.numerator() * factor);
  }
  return f;
}

Fractions plus(const Fractions& a, const Fractions& b, int sign) {
  const bool alike = a.denominator == b.denominator;
  const Integer one(1);
  const Integer& to_a = alike ? one : b.denominator;
  const Integer& to_b = alike ? one : a.denominator;
  Fractions sum;
  sum.denominator = alike ? a.denominator : a.denominator * b.denominator;
  sum.c.resize(std::max(a.c.size(), b.c.size()));
  for (std::size_t i = 0; i < a.c.size(); ++i) sum.c[i].add_product(a.c[i], to_a);
  for (std::size_t i = 0; i < b.c.size(); ++i) {
    if (sign > 0) {
      sum.c[i].add_product(b.c[i], to_b);
    } else {
      sum.c[i].subtract_product(b.c[i], to_b);
    }
  }
  return sum;
}
Fractions operator+(const Fractions& a, const Fractions& b) { return plus(a, b, 1); }
Fractions operator-(const Fractions& a, const Fractions& b) { return plus(a, b, -1); }
Fractions operator*(const Fractions& a, const Fractions& b) {
  Fractions product;
  product.denominator = a.denominator * b.denominator;
  product.c.resize(a.c.size() + b.c.size() - 1);
  for (std::size_t i = 0; i < a.c.size(); ++i) {
    if (a.c[i].is_zero()) continue;
    for (std::size_t j = 0; j < b.c.size(); ++j) product.c[i + j].add_product(a.c[i], b.c[j]);
  }
  return product;
}

template <class Form>
struct Turn {  // the square of a rotor, and its absolute value
  Form c, s, n;
};
template <class Form>
Turn<Form> square(const Form& p, const Form& q) {
  const Form pp = p * p, qq = q * q, pq = p * q;
  return {pp - qq, pq + pq, pp + qq};
}

template <class Form>
using Body = std::array<Form, kBodyAxes>;

template <class Form>
std::array<Form, kPoseAxes> pose_axes(const Body<Form>& a, const Body<Form>& b) {
  const Form x = b[0] - a[0], y = b[1] - a[1];
  const Turn<Form> turn_a = square(a[2], a[3]), turn_b = square(b[2], b[3]);
  // conj(w_A) w_B
  const Turn<Form> turn = square(a[2] * b[2] + a[3] * b[3], a[2] * b[3] - a[3] * b[2]);
  return {turn_b.n * (turn_a.c * x + turn_a.s * y),
          turn_b.n * (turn_a.c * y - turn_a.s * x),
          turn_a.n * (turn_b.c * x + turn_b.s * y),
          turn_a.n * (turn_b.c * y - turn_b.s * x),
          turn.n,
          turn.c,
          turn.s};
}

// Numbers with more bits than this are scaled.
constexpr std::size_t kLong = 400;

// In machine integers; nullopt if the pose overflows them.
std::optional<Trajectory> short_pose(std::span<const Trajectory* const> bases) {
  std::array<Body<DyadicPolynomial>, 2> body;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t axis = 0; axis < kBodyAxes; ++axis) {
      body[i][axis] = DyadicPolynomial::of(bases[i]->coordinates[axis]);
      if (!body[i][axis].is_valid()) return std::nullopt;
    }
  }
  const auto axes = pose_axes(body[0], body[1]);
  unsigned common = 0;
  for (const DyadicPolynomial& axis : axes) {
    if (!axis.is_valid()) return std::nullopt;
    common = std::max(common, axis.denominator_bits());
  }
  for (const DyadicPolynomial& axis : axes) {
    if (axis.bits(common) > kLong) return std::nullopt;
  }
  Trajectory pose;
  pose.coordinates.resize(kPoseAxes);
  for (std::size_t i = 0; i < kPoseAxes; ++i) axes[i].write(common, pose.coordinates[i]);
  return pose;
}

class Pose2 final : public Construction {
 public:
  explicit Pose2(bool tries_short) : tries_short_(tries_short) {}
  std::string_view name() const override { return "pose_2"; }

  Trajectory derive(std::span<const Trajectory* const> bases) const override {
    for (const Trajectory* base : bases) {
      require(base->dimension() == kBodyAxes, "a pose is of two bodies");
    }
    if (tries_short_) {
      if (auto pose = short_pose(bases)) return *std::move(pose);
    }
    std::array<Body<Fractions>, 2> body;
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t axis = 0; axis < kBodyAxes; ++axis) {
        body[i][axis] = fractions(bases[i]->coordinates[axis]);
      }
    }
    return whole(pose_axes(body[0], body[1]));
  }

 private:
  // All axes times the same positive number, so that nothing is left to reduce; very long numbers
  // are scaled by a power of two that keeps them in the range of doubles.
  static Trajectory whole(const std::array<Fractions, kPoseAxes>& axes) {
    Integer common(1);
    for (const Fractions& axis : axes) common = lcm(common, axis.denominator);
    Trajectory pose;
    std::size_t bits = 0;
    for (const Fractions& axis : axes) {
      Integer factor = common;
      factor.divide_exactly(axis.denominator);
      std::vector<Rational>& coefficients = pose.coordinates.emplace_back();
      for (const Integer& i : axis.c) {
        Integer scaled = i * factor;
        bits = std::max(bits, scaled.bit_length());
        coefficients.emplace_back(std::move(scaled));
      }
    }
    if (bits > kLong) {
      const Rational scale(Integer(1), Integer::power_of_two(bits - 1));
      for (auto& axis : pose.coordinates) {
        for (Rational& c : axis) c *= scale;
      }
    }
    pose.normalise();
    return pose;
  }

  bool tries_short_;
};

}  // namespace

std::shared_ptr<const Construction> make_pose_2() { return std::make_shared<Pose2>(true); }
DerivedKind pose_2_kind(const Scene& scene) {
  int centre = 0, first = 0, second = 0;  // the two largest degrees of rotors
  for (const SceneObject& object : scene.objects) {
    int rotor = 0;
    for (const MotionPiece& piece : object.motion.pieces) {
      centre = std::max(centre, piece.trajectory.degree_of_axes(0, 2));
      rotor = std::max(rotor, piece.trajectory.degree_of_axes(2, kBodyAxes));
    }
    second = std::max(second, std::min(first, rotor));
    first = std::max(first, rotor);
  }
  return {"pose_2", kPoseAxes, centre + 2 * (first + second), true};
}

std::shared_ptr<const Construction> make_long_pose_2() { return std::make_shared<Pose2>(false); }

}  // namespace kinex
