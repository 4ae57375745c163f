// SPDX-License-Identifier: GPL-3.0-or-later
// Predicate: a polynomial in the motions of a few objects. A certificate claims that it is >= 0.
// This is the interface that the arithmetics use; a predicate's formula is written once, over any
// ring, and adapted to this interface by core/arithmetic/predicate_formula.h.
#ifndef KINEX_CORE_ARITHMETIC_PREDICATE_H
#define KINEX_CORE_ARITHMETIC_PREDICATE_H

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/arithmetic/claim_form.h"
#include "core/numbers/ball.h"
#include "core/numbers/integer.h"
#include "core/numbers/lanes.h"
#include "core/numbers/mp_float.h"
#include "core/numbers/polynomial.h"

namespace kinex {

using PredicateId = std::uint16_t;  // given by Arithmetic::bind

// No predicate takes more objects than this.
inline constexpr int kMaxArity = 10;
// The motion degrees that have fixed-size polynomials; higher ones use dynamic sizes.
inline constexpr int kMaxFixedDegree = 3;
// Room for the coefficients of a certificate polynomial of fixed size: degree 8 * 3 plus one. A
// predicate is checked against it when it is bound; one that does not fit uses dynamic sizes.
inline constexpr int kMaxFixedCoefficients = 25;
// The axes of objects that predicates of fixed size read.
inline constexpr int kMaxFixedAxes = 8;
// The largest number of views passed to a predicate: one for each argument, and one for the unit
// (Predicate::has_unit).
inline constexpr int kMaxViews = kMaxArity + 1;

// The motion of one object in ring R: the coefficient of t^k on axis a is entry
// a * (motion_degree + 1) + k.
template <class R>
using MotionView = const R*;

class Predicate {
 public:
  virtual ~Predicate() = default;

  virtual std::string_view name() const = 0;
  virtual int arity() const = 0;
  // The number of axes that are read; objects must have at least as many.
  virtual int dimension() const = 0;
  // Degree in t of the polynomial for motions of degree d.
  virtual int degree(int motion_degree) const = 0;
  // Permuting the first `alternating()` arguments multiplies the value by the permutation's sign;
  // the roots stay the same. 0 or 1: no identity.
  virtual int alternating() const = 0;
  // Exchanging the first half of the arguments with the second one, in order, multiplies the value
  // by -1; the roots stay the same.
  virtual bool alternates_in_halves() const { return false; }

  // An arithmetic may keep coordinates times a common factor s. A formula whose terms have
  // different degrees in the coordinates multiplies the lower ones by powers of the unit, which is
  // s itself. So it is homogeneous, and its sign does not depend on s. If true, points[arity()] is
  // a view of one number, the unit; it is 1 where coordinates are kept without a factor.
  virtual bool has_unit() const { return false; }

  // The name of the predicate with the negated value over the same arguments; empty: none.
  virtual std::string_view opposite() const { return {}; }
  // True if the value is that of `other` negated, over the same arguments. An arithmetic then finds the
  // roots of one by the other. By default the other one has the name opposite().
  virtual bool negates(const Predicate& other) const {
    return !opposite().empty() && other.name() == opposite();
  }

  // The claim in words, with the role of every argument. Default: nothing is known.
  virtual ClaimForm form() const { return {}; }

  // The value as a polynomial in t, low degree first, degree(motion_degree) + 1 coefficients.
  // points[i] is the motion of the i-th argument; points[arity()] the unit, if has_unit().
  //
  // Exact machine integers; requires narrow_fits(); motion_degree <= kMaxFixedDegree.
  virtual void narrow(int motion_degree, const MotionView<std::int64_t>* points, Int128* out) const = 0;
  // True if `narrow` cannot overflow (the predicate's own constants included) for motions whose
  // coefficient of t^k is at most magnitude[k] in absolute value on every axis, and for this unit.
  virtual bool narrow_fits(int motion_degree, const double* magnitude, double unit) const = 0;
  // Doubles with proven error bounds, as a polynomial in t - shift (in t unless shifts()).
  virtual void ball(int motion_degree, const MotionView<Ball>* points, double shift,
                    Ball* out) const = 0;
  // True if `ball` shifts motions of this degree.
  virtual bool shifts(int motion_degree) const { return motion_degree <= kMaxFixedDegree; }
  // Plain doubles, as a polynomial in t - shift, no error accounting. The motions are shifted
  // first, so that differences of positions near that time are small.
  // motion_degree > kMaxFixedDegree: shift = 0.
  virtual void plain(int motion_degree, const MotionView<double>* points, double shift,
                     double* out) const = 0;
  // As `plain`, and reach[k] = the largest |difference| from the reference argument in the
  // coefficient of (t - shift)^k, over the other arguments and all axes. On axes that enter by
  // value (weights) it is the largest |coefficient|, over all arguments; the unit counts in
  // reach[0].
  // motion_degree <= kMaxFixedDegree.
  virtual void plain_with_reach(int motion_degree, const MotionView<double>* points, double shift,
                                double* out, double* reach) const = 0;
  // As `plain_with_reach` for kLanes queries side by side: points[i * kLanes + j] is the motion of the
  // i-th argument of query j. Every lane holds bit for bit the numbers of `plain_with_reach`. False,
  // with nothing written: the predicate has no such form. Requires a machine with `vectors`.
  virtual bool plain_lanes(int motion_degree, const MotionView<double>* points, double shift,
                           Vectors vectors, Lanes* out, Lanes* reach) const {
    static_cast<void>(motion_degree), static_cast<void>(points), static_cast<void>(shift);
    static_cast<void>(vectors), static_cast<void>(out), static_cast<void>(reach);
    return false;
  }
  // If the shifted motions and their differences are exact in doubles, then coefficient k of
  // plain_with_reach is off by at most this number times coefficient k of
  // (reach[0] + reach[1] t + ..)^homogeneity() (underflow aside). Infinity: nothing is known; `ball`
  // is used instead. motion_degree <= kMaxFixedDegree.
  virtual double reach_error(int motion_degree) const = 0;
  // The formula's degree in the coordinates and the unit.
  virtual int homogeneity() const = 0;
  // MPFR numbers of the points' precision.
  virtual void multiprecision(int motion_degree, const MotionView<MpFloat>* points,
                              MpFloat* out) const = 0;
  // Exact integers. The value may carry a positive constant factor, the same for all calls.
  virtual Polynomial exact(int motion_degree, const MotionView<Integer>* points) const = 0;
  // Exact rationals, for the reference arithmetic: low degree first, not stripped.
  virtual std::vector<Rational> rational(int motion_degree,
                                         const MotionView<Rational>* points) const = 0;
};

}  // namespace kinex

#endif
