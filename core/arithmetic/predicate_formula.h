// SPDX-License-Identifier: GPL-3.0-or-later
// FormulaPredicate: adapts one formula, written once over any ring, to the Predicate interface.
//
// A Formula is a class with
//   static constexpr int kArity, kDegree (in units of the motion's degree), kAlternating;
//   static constexpr int kReference;         the argument that differences are taken from
//   static constexpr bool kOnlyToReference;  every coordinate enters as such a difference
//   name(), dimension(), form() (core/arithmetic/claim_form.h);
//   template <class Points> auto value(const Points& p) const;
// where p(i, axis) is the polynomial of the i-th argument on that axis and value() returns a
// polynomial in the wide ring (through widen or wide_product). The formula must
//   (1) be homogeneous of degree kDegree in the coordinates of its arguments, and
//   (2) use them only through differences of two arguments on one axis.
// Formulas with weights and constants declare what is different:
//   static constexpr bool kHasUnit = true;   p.unit() stands for the number 1; terms are multiplied
//                                            by it until all have the same degree in coordinates
//                                            and unit
//   static constexpr int kHomogeneity;       that degree, if it is not kDegree
//   int first_by_value() const;              coordinates on this axis and all later ones enter by
//                                            value, not only through differences (0: all axes)
//   int square_axis() const;                 coordinates on this axis enter only as differences from
//                                            the reference, times the unit, in the place of a square
//                                            of other differences (weights). Such a formula has
//                                            kHasUnit and kOnlyToReference
// Formulas whose certificates are renewed in groups (Kernel::Group) may say so. They have no unit.
//   static constexpr bool kInGroups = true;  compiled over Lanes, too
#ifndef KINEX_CORE_ARITHMETIC_PREDICATE_FORMULA_H
#define KINEX_CORE_ARITHMETIC_PREDICATE_FORMULA_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/predicate.h"
#include "core/numbers/check.h"
#include "core/numbers/ring_polynomial.h"

namespace kinex {

template <class R, int D>  // arguments of a formula, of fixed degree D
struct FixedPoints {
  const MotionView<R>* points;
  int arity = 0;
  FixedPolynomial<R, D> operator()(int i, int axis) const {
    FixedPolynomial<R, D> p;
    for (int k = 0; k <= D; ++k) p.c[k] = points[i][axis * (D + 1) + k];
    return p;
  }
  FixedPolynomial<R, 0> unit() const { return {{*points[arity]}}; }
};

template <class R>  // arguments of a formula, of any degree
struct DynamicPoints {
  const MotionView<R>* points;
  int degree;
  int arity = 0;
  DynamicPolynomial<R> operator()(int i, int axis) const {
    const R* first = points[i] + static_cast<std::ptrdiff_t>(axis) * (degree + 1);
    return {std::vector<R>(first, first + degree + 1)};
  }
  DynamicPolynomial<R> unit() const { return {std::vector<R>(1, *points[arity])}; }
};

// The same magnitudes for every argument and axis.
template <int D>
struct MagnitudePoints {
  const double* magnitude;
  double unit_magnitude = 1;
  FixedPolynomial<Magnitude, D> operator()(int, int) const {
    FixedPolynomial<Magnitude, D> p;
    for (int k = 0; k <= D; ++k) p.c[k] = Magnitude{magnitude[k], 0, 0, false}.noted();
    return p;
  }
  FixedPolynomial<Magnitude, 0> unit() const {
    return {{Magnitude{unit_magnitude, 0, 0, false}.noted()}};
  }
};

// Every coefficient of a coordinate is at most `magnitude` (1 on axes that enter by value) times
// the reach. The unit is exact, but not a multiple of the coordinates' power of two.
template <int D>
struct RoundingPoints {
  double magnitude;
  int first_by_value;
  FixedPolynomial<RoundingBound, D> operator()(int, int axis) const {
    FixedPolynomial<RoundingBound, D> p;
    for (int k = 0; k <= D; ++k) p.c[k] = {axis < first_by_value ? magnitude : 1.0, 0, true};
    return p;
  }
  FixedPolynomial<RoundingBound, 0> unit() const { return {{{1, 0, false}}}; }
};

// Motions as polynomials in t - shift.
template <class R, int D>
struct ShiftedPoints {
  const MotionView<R>* points;
  R shift;
  int arity = 0;
  FixedPolynomial<R, D> operator()(int i, int axis) const {
    FixedPolynomial<R, D> p;
    for (int k = 0; k <= D; ++k) p.c[k] = points[i][axis * (D + 1) + k];
    for (int k = 0; k < D; ++k) {
      for (int j = D - 1; j >= k; --j) p.c[j] += shift * p.c[j + 1];
    }
    return p;
  }
  // All axes of an argument, from the coefficient of t^0 on axis 0.
  void shift_all(int i, int axes, R* out) const {
    for (int axis = 0; axis < axes; ++axis) {
      const auto p = (*this)(i, axis);
      for (int k = 0; k <= D; ++k) out[axis * (D + 1) + k] = p.c[k];
    }
  }
  FixedPolynomial<R, 0> unit() const { return {{*points[arity]}}; }
};

// The same of kLanes queries side by side: points[i * kLanes + j] is the i-th argument of query j.
template <int D>
struct ShiftedLanes {
  const MotionView<double>* points;
  double shift;
  [[gnu::always_inline]] void shift_all(int i, int axes, Lanes* out) const {
    const MotionView<double>* const p = points + static_cast<std::size_t>(i) * kLanes;
    const int count = axes * (D + 1);
    int first = 0;
    for (; first + 4 <= count; first += 4) {
      transpose(p[0] + first, p[1] + first, p[2] + first, p[3] + first, out + first);
    }
    for (int k = first; k < count; ++k) out[k] = Lanes(p[0][k], p[1][k], p[2][k], p[3][k]);
    for (int axis = 0; axis < axes; ++axis) {
      Lanes* const c = out + axis * (D + 1);
      for (int k = 0; k < D; ++k) {
        for (int j = D - 1; j >= k; --j) c[j] += shift * c[j + 1];
      }
    }
  }
};

template <class Formula>
class FormulaPredicate : public Predicate {
 public:
  explicit FormulaPredicate(Formula formula = {}) : formula_(std::move(formula)) {
    require(formula_.dimension() <= kMaxFixedAxes, "a formula reads too many axes");
  }

  std::string_view name() const override { return formula_.name(); }
  int arity() const override { return Formula::kArity; }
  int dimension() const override { return formula_.dimension(); }
  int degree(int motion_degree) const override { return Formula::kDegree * motion_degree; }
  int alternating() const override { return Formula::kAlternating; }
  bool alternates_in_halves() const override {
    return requires { Formula::kAlternatesInHalves; };
  }
  bool has_unit() const override { return kHasUnit; }
  bool negates(const Predicate& other) const override {
    if constexpr (requires { formula_.negates(formula_); }) {
      const auto* same = dynamic_cast<const FormulaPredicate*>(&other);
      return same != nullptr && formula_.negates(same->formula_);
    } else {
      return Predicate::negates(other);
    }
  }
  ClaimForm form() const override {
    if constexpr (requires { formula_.form(); }) {
      return formula_.form();
    } else {
      return {};
    }
  }

  void narrow(int d, const MotionView<std::int64_t>* points, Int128* out) const override {
    fixed<std::int64_t>(d, points, out);
  }

  bool narrow_fits(int d, const double* magnitude, double unit) const override {
    switch (d) {
      case 1: return magnitudes_fit(formula_.value(MagnitudePoints<1>{magnitude, unit}));
      case 2: return magnitudes_fit(formula_.value(MagnitudePoints<2>{magnitude, unit}));
      case 3: return magnitudes_fit(formula_.value(MagnitudePoints<3>{magnitude, unit}));
      default: return false;
    }
  }

  void ball(int d, const MotionView<Ball>* points, double shift, Ball* out) const override {
    const Ball s{shift, 0};
    switch (d) {
      case 1: return store(formula_.value(ShiftedPoints<Ball, 1>{points, s, Formula::kArity}), out);
      case 2: return store(formula_.value(ShiftedPoints<Ball, 2>{points, s, Formula::kArity}), out);
      case 3: return store(formula_.value(ShiftedPoints<Ball, 3>{points, s, Formula::kArity}), out);
      default: return dynamic(d, points, out);
    }
  }

  void plain(int d, const MotionView<double>* points, double shift, double* out) const override {
    switch (d) {
      case 1: return store(formula_.value(ShiftedPoints<double, 1>{points, shift, Formula::kArity}), out);
      case 2: return store(formula_.value(ShiftedPoints<double, 2>{points, shift, Formula::kArity}), out);
      case 3: return store(formula_.value(ShiftedPoints<double, 3>{points, shift, Formula::kArity}), out);
      default: return dynamic(d, points, out);
    }
  }

  void plain_with_reach(int d, const MotionView<double>* points, double shift, double* out,
                        double* reach) const override {
    switch (d) {
      case 1: return reaching(ShiftedPoints<double, 1>{points, shift, Formula::kArity}, out, reach);
      case 2: return reaching(ShiftedPoints<double, 2>{points, shift, Formula::kArity}, out, reach);
      default: return reaching(ShiftedPoints<double, 3>{points, shift, Formula::kArity}, out, reach);
    }
  }

  bool plain_lanes(int d, const MotionView<double>* points, double shift, Vectors vectors,
                   Lanes* out, Lanes* reach) const override {
    if constexpr (kInGroups) {
      switch (d) {
        case 1: return in_lanes(ShiftedLanes<1>{points, shift}, vectors, out, reach);
        case 2: return in_lanes(ShiftedLanes<2>{points, shift}, vectors, out, reach);
        case 3: return in_lanes(ShiftedLanes<3>{points, shift}, vectors, out, reach);
        default: return false;
      }
    } else {
      return Predicate::plain_lanes(d, points, shift, vectors, out, reach);
    }
  }

  double reach_error(int d) const override {
    // Differences are at most the reach, or twice that where they are not taken from the reference.
    // Those on the axis of squares are at most its square, with a unit of 1.
    const double magnitude = Formula::kOnlyToReference ? 0.5 : 1.0;
    const int by_value = kHasSquareAxis ? kMaxFixedAxes : first_by_value();
    switch (d) {
      case 1: return relative_error(formula_.value(RoundingPoints<1>{magnitude, by_value}));
      case 2: return relative_error(formula_.value(RoundingPoints<2>{magnitude, by_value}));
      default: return relative_error(formula_.value(RoundingPoints<3>{magnitude, by_value}));
    }
  }

  int homogeneity() const override {
    if constexpr (requires { Formula::kHomogeneity; }) {
      return Formula::kHomogeneity;
    } else {
      return Formula::kDegree;
    }
  }

  void multiprecision(int d, const MotionView<MpFloat>* points, MpFloat* out) const override {
    dynamic(d, points, out);
  }

  Polynomial exact(int d, const MotionView<Integer>* points) const override {
    return Polynomial(formula_.value(DynamicPoints<Integer>{points, d, Formula::kArity}).c);
  }

  std::vector<Rational> rational(int d, const MotionView<Rational>* points) const override {
    return formula_.value(DynamicPoints<Rational>{points, d, Formula::kArity}).c;
  }

 private:
  static constexpr bool has_unit_of_formula() {
    if constexpr (requires { Formula::kHasUnit; }) {
      return Formula::kHasUnit;
    } else {
      return false;
    }
  }
  static constexpr bool kHasUnit = has_unit_of_formula();
  static constexpr bool in_groups() {
    if constexpr (requires { Formula::kInGroups; }) {
      return Formula::kInGroups;
    } else {
      return false;
    }
  }
  static constexpr bool kInGroups = in_groups();
  static_assert(!(kInGroups && kHasUnit));
  static constexpr bool has_square_axis() {
    return requires(const Formula& formula) { formula.square_axis(); };
  }
  static constexpr bool kHasSquareAxis = has_square_axis();
  static_assert(!kHasSquareAxis || (kHasUnit && Formula::kOnlyToReference));

  int first_by_value() const {
    if constexpr (requires { formula_.first_by_value(); }) {
      return formula_.first_by_value();
    } else {
      return kMaxFixedAxes;
    }
  }

  template <class R, class Out>
  void fixed(int d, const MotionView<R>* points, Out* out) const {
    switch (d) {
      case 1: return store(formula_.value(FixedPoints<R, 1>{points, Formula::kArity}), out);
      case 2: return store(formula_.value(FixedPoints<R, 2>{points, Formula::kArity}), out);
      default: return store(formula_.value(FixedPoints<R, 3>{points, Formula::kArity}), out);
    }
  }

  template <class R, int D>
  static void store(const FixedPolynomial<R, D>& p, R* out) {
    for (int i = 0; i <= D; ++i) out[i] = p.c[i];
  }

  // The motions are shifted once, for both.
  template <int D>
  void reaching(const ShiftedPoints<double, D>& points, double* out, double* reach) const {
    const MotionView<double>* const unit = kHasUnit ? &points.points[Formula::kArity] : nullptr;
    reaching<D>(points, unit, out, reach);
  }

  template <int D>
  bool in_lanes(const ShiftedLanes<D>& points, Vectors vectors, Lanes* out, Lanes* reach) const {
    if (vectors == Vectors::kAvx2) {
      in_avx2<D>(points, out, reach);
    } else {
      reaching<D>(points, static_cast<const MotionView<Lanes>*>(nullptr), out, reach);
    }
    return true;
  }
  template <int D>
  KINEX_FOR_AVX2 void in_avx2(const ShiftedLanes<D>& points, Lanes* out, Lanes* reach) const {
    reaching<D>(points, static_cast<const MotionView<Lanes>*>(nullptr), out, reach);
  }

  // R: double, or Lanes.
  template <int D, class R, class Points>
  void reaching(const Points& points, const MotionView<R>* unit, R* out, R* reach) const {
    constexpr int kPowers = D + 1;
    const int axes = formula_.dimension();
    R shifted[Formula::kArity][kMaxFixedAxes * kPowers];
    MotionView<R> views[Formula::kArity + 1];
    for (int i = 0; i < Formula::kArity; ++i) {
      views[i] = shifted[i];
      points.shift_all(i, axes, shifted[i]);
    }
    for (int k = 0; k <= D; ++k) reach[k] = 0;
    if constexpr (kHasUnit) {
      views[Formula::kArity] = *unit;
      if constexpr (!kHasSquareAxis) reach[0] = magnitude_of(**unit);
    }
    const int differences = std::min(axes, first_by_value());
    for (int axis = differences; axis < axes; ++axis) {
      if constexpr (kHasSquareAxis) {
        if (axis == formula_.square_axis()) continue;
      }
      for (int i = 0; i < Formula::kArity; ++i) {
        for (int k = 0; k <= D; ++k) {
          reach[k] = larger(reach[k], magnitude_of(shifted[i][axis * kPowers + k]));
        }
      }
    }
    for (int axis = 0; axis < differences; ++axis) {
      for (int i = 0; i < Formula::kArity; ++i) {
        if (i == Formula::kReference) continue;
        for (int k = 0; k <= D; ++k) {
          const int at = axis * kPowers + k;
          reach[k] = larger(reach[k],
                            magnitude_of(shifted[i][at] - shifted[Formula::kReference][at]));
        }
      }
    }
    if constexpr (kHasSquareAxis) {
      R squares[D + 1];
      for (int k = 0; k <= D; ++k) squares[k] = 0;
      const int first = formula_.square_axis() * kPowers;
      for (int i = 0; i < Formula::kArity; ++i) {
        for (int k = 0; k <= D; ++k) {
          const R difference = shifted[i][first + k] - shifted[Formula::kReference][first + k];
          squares[k] = larger(squares[k], magnitude_of(difference * **unit));
        }
      }
      cover_squares<D>(squares, reach);
    }
    store(formula_.value(FixedPoints<R, D>{views, Formula::kArity}), out);
  }

  // Enlarges the reach until every coefficient of its square is at least squares[k], k <= D: that of
  // t^k is at least 2 reach[0] reach[k].
  template <int D>
  static void cover_squares(const double* squares, double* reach) {
    reach[0] = std::max(reach[0], std::sqrt(squares[0]));
    if (reach[0] == 0) reach[0] = std::sqrt(*std::max_element(squares, squares + D + 1));
    for (int k = 1; k <= D; ++k) {
      if (squares[k] > 0) reach[k] = std::max(reach[k], squares[k] / (2 * reach[0]));
    }
  }

  // With every difference bounded by the same polynomial R(t), the formula's absolute values add up
  // to C R^homogeneity. C is the lowest coefficient for R = 1 + t + ..
  template <int D>
  static double relative_error(const FixedPolynomial<RoundingBound, D>& p) {
    double roundings = 0;
    for (const RoundingBound& c : p.c) roundings = std::max(roundings, c.roundings);
    return roundings * 0x1p-53 * (1 + 0x1p-30) * p.c[0].magnitude;
  }

  template <class R>
  void dynamic(int d, const MotionView<R>* points, R* out) const {
    DynamicPolynomial<R> p = formula_.value(DynamicPoints<R>{points, d, Formula::kArity});
    for (std::size_t i = 0; i < p.c.size(); ++i) out[i] = std::move(p.c[i]);
  }

  // Limits: 64-bit values stay below 2^62 and 128-bit ones below 2^125; the peaks are sums and
  // products of doubles rounded to nearest, off by far less than the factor of two left.
  template <int D>
  static bool magnitudes_fit(const FixedPolynomial<Magnitude, D>& p) {
    for (const Magnitude& m : p.c) {
      if (!(m.narrow_peak < 0x1p62 && m.wide_peak < 0x1p125)) return false;
    }
    return true;
  }

  Formula formula_;
};

}  // namespace kinex

#endif
