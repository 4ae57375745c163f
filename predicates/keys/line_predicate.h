// SPDX-License-Identifier: GPL-3.0-or-later
// LinePredicate: adapts predicates on keys of linear motions, seen as lines, to the Predicate
// interface. key_i(t) = slope_i t + height_i is the point (slope_i, height_i) of the dual plane.
// The value is a number, not a function of t: degree 0. It changes only when a motion does. The
// predicates and their identities: predicates/predicates.h.
//
// Terms beyond t^1 are ignored: such predicates are for structures that take linear motions only.
//   inexact arithmetics              doubles without error bounds
//   exact, scenes of small integers  128-bit integers
//   exact, other scenes              doubles with error bounds, then integers of any size
#ifndef KINEX_PREDICATES_KEYS_LINE_PREDICATE_H
#define KINEX_PREDICATES_KEYS_LINE_PREDICATE_H

#include <limits>
#include <utility>
#include <vector>

#include "core/arithmetic/predicate_formula.h"

namespace kinex {

// The key of the line predicates: v.x for the primitive integer vector of a direction (one
// coordinate: a unit vector).
struct LineKey {
  std::vector<FormulaConstant> direction;

  int dimension() const { return static_cast<int>(direction.size()); }
  // key(b) - key(a), as a polynomial in t.
  template <class Points>
  auto difference(const Points& p, int a, int b) const {
    auto sum = scaled(p(b, 0) - p(a, 0), direction[0]);
    for (int axis = 1; axis < dimension(); ++axis) {
      sum = sum + scaled(p(b, axis) - p(a, axis), direction[static_cast<std::size_t>(axis)]);
    }
    return sum;
  }
  // slope_b - slope_a and the same for heights, of a difference.
  template <class Polynomial>
  static auto slope(const Polynomial& difference) {
    return difference.c[1];
  }
  template <class Polynomial>
  static auto height(const Polynomial& difference) {
    return difference.c[0];
  }
  // The turn from u to v, in the wide ring.
  template <class Polynomial>
  static auto turn(const Polynomial& u, const Polynomial& v) {
    using W = WideRing<typename Polynomial::Ring>;
    return W::product(slope(u), height(v)) - W::product(height(u), slope(v));
  }
};

// A Formula has kArity, kAlternating, kHomogeneity, kRoles, kSays, name(), and
// value(points, key) in the wide ring.
template <class Formula>
class LinePredicate final : public Predicate {
 public:
  explicit LinePredicate(LineKey key) : key_(std::move(key)) {}

  std::string_view name() const override { return Formula::name(); }
  int arity() const override { return Formula::kArity; }
  int dimension() const override { return key_.dimension(); }
  int degree(int) const override { return 0; }
  int alternating() const override { return Formula::kAlternating; }
  int homogeneity() const override { return Formula::kHomogeneity; }
  ClaimForm form() const override {
    return {ClaimFigure::kNone, 1, Formula::kRoles, Formula::kSays, {}};
  }

  void narrow(int d, const MotionView<std::int64_t>* points, Int128* out) const override {
    fixed<std::int64_t>(d, points, out);
  }
  bool narrow_fits(int d, const double* magnitude, double) const override {
    switch (d) {
      case 1:
        return fits(Formula::value(MagnitudePoints<1>{magnitude}, key_));
      case 2:
        return fits(Formula::value(MagnitudePoints<2>{magnitude}, key_));
      case 3:
        return fits(Formula::value(MagnitudePoints<3>{magnitude}, key_));
      default:
        return false;
    }
  }
  // The value does not depend on the origin of time.
  void ball(int d, const MotionView<Ball>* points, double, Ball* out) const override {
    d <= kMaxFixedDegree ? fixed<Ball>(d, points, out) : dynamic(d, points, out);
  }
  void plain(int d, const MotionView<double>* points, double, double* out) const override {
    d <= kMaxFixedDegree ? fixed<double>(d, points, out) : dynamic(d, points, out);
  }
  // No bound is known; callers that need one use another stage.
  void plain_with_reach(int d, const MotionView<double>* points, double shift, double* out,
                        double* reach) const override {
    plain(d, points, shift, out);
    for (int k = 0; k <= d; ++k) reach[k] = 1;
  }
  double reach_error(int) const override { return std::numeric_limits<double>::infinity(); }
  void multiprecision(int d, const MotionView<MpFloat>* points, MpFloat* out) const override {
    dynamic(d, points, out);
  }
  Polynomial exact(int d, const MotionView<Integer>* points) const override {
    return Polynomial({Formula::value(DynamicPoints<Integer>{points, d}, key_)});
  }
  std::vector<Rational> rational(int d, const MotionView<Rational>* points) const override {
    return {Formula::value(DynamicPoints<Rational>{points, d}, key_)};
  }

 private:
  template <class R, class Out>
  void fixed(int d, const MotionView<R>* points, Out* out) const {
    switch (d) {
      case 1:
        out[0] = Formula::value(FixedPoints<R, 1>{points}, key_);
        return;
      case 2:
        out[0] = Formula::value(FixedPoints<R, 2>{points}, key_);
        return;
      default:
        out[0] = Formula::value(FixedPoints<R, 3>{points}, key_);
        return;
    }
  }
  template <class R>
  void dynamic(int d, const MotionView<R>* points, R* out) const {
    out[0] = Formula::value(DynamicPoints<R>{points, d}, key_);
  }
  // See FormulaPredicate.
  static bool fits(const Magnitude& m) { return m.narrow_peak < 0x1p62 && m.wide_peak < 0x1p125; }

  LineKey key_;
};

}  // namespace kinex

#endif
