// SPDX-License-Identifier: GPL-3.0-or-later
// WidePredicate: adapts a formula whose arguments differ in kind (poses, constants, bodies) to the
// Predicate interface: no machine integers, doubles with error bounds and then exact numbers.
//
// A Formula is a class with
//   static constexpr int kArity, kHomogeneity;
//   name(), degree(motion_degree), form() (core/arithmetic/claim_form.h), and opposite() if
//   there is an opposite predicate;
//   static constexpr bool kFailsAtTouch = true; if it FailsAtTouch (core/arithmetic/touch.h);
//   template <class R> void value(int motion_degree, const MotionView<R>* points, R* out,
//                                 const R& zero) const;
// where value() writes degree(motion_degree) + 1 coefficients in t. Coefficients that are zero in
// every argument must be exact zeros.
#ifndef KINEX_PREDICATES_BODIES_WIDE_PREDICATE_H
#define KINEX_PREDICATES_BODIES_WIDE_PREDICATE_H

#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/arithmetic/predicate.h"
#include "core/arithmetic/touch.h"

namespace kinex {

// Zero for certain.
inline bool is_exactly_zero(const Ball& b) { return b.value == 0 && b.error == 0; }
inline bool is_exactly_zero(double d) { return d == 0; }
inline bool is_exactly_zero(const Integer& i) { return i.is_zero(); }
inline bool is_exactly_zero(const Rational& q) { return q.is_zero(); }
inline bool is_exactly_zero(const MpFloat& f) { return f.sign() == 0 && f.is_finite(); }

struct FailsWhereNegative {};  // the failure rule of most formulas
template <class Formula>  // a formula with kFailsAtTouch fails at touches, too
using FailureRule = std::conditional_t < requires {
  Formula::kFailsAtTouch;
}
, FailsAtTouch, FailsWhereNegative > ;

template <class Formula>
class WidePredicate : public Predicate, public FailureRule<Formula> {
 public:
  explicit WidePredicate(Formula formula) : formula_(std::move(formula)) {}

  std::string_view name() const override { return formula_.name(); }
  int arity() const override { return Formula::kArity; }
  int dimension() const override { return Formula::kDimension; }
  int degree(int motion_degree) const override { return formula_.degree(motion_degree); }
  int alternating() const override { return 0; }
  ClaimForm form() const override { return formula_.form(); }
  std::string_view opposite() const override {
    if constexpr (requires { formula_.opposite(); }) {
      return formula_.opposite();
    } else {
      return {};
    }
  }
  int homogeneity() const override { return Formula::kHomogeneity; }

  // Motions of bodies never use machine integers.
  bool narrow_fits(int, const double*, double) const override { return false; }
  void narrow(int, const MotionView<std::int64_t>*, Int128*) const override { refuse(); }
  void plain_with_reach(int, const MotionView<double>*, double, double*, double*) const override {
    refuse();
  }
  double reach_error(int) const override { return std::numeric_limits<double>::infinity(); }

  bool shifts(int) const override { return true; }
  void ball(int d, const MotionView<Ball>* points, double shift, Ball* out) const override {
    formula_.value(d, points, out, Ball{});
    taylor_shift(degree(d), Ball{shift, 0}, out);
  }
  void plain(int d, const MotionView<double>* points, double shift, double* out) const override {
    formula_.value(d, points, out, 0.0);
    taylor_shift(degree(d), shift, out);
  }
  void multiprecision(int d, const MotionView<MpFloat>* points, MpFloat* out) const override {
    formula_.value(d, points, out, MpFloat(points[0][0].precision()));
  }
  Polynomial exact(int d, const MotionView<Integer>* points) const override {
    std::vector<Integer> out(static_cast<std::size_t>(degree(d)) + 1);
    formula_.value(d, points, out.data(), Integer());
    return Polynomial(std::move(out));
  }
  std::vector<Rational> rational(int d, const MotionView<Rational>* points) const override {
    std::vector<Rational> out(static_cast<std::size_t>(degree(d)) + 1);
    formula_.value(d, points, out.data(), Rational());
    return out;
  }

 private:
  [[noreturn]] static void refuse() {
    throw std::logic_error("a predicate on bodies was asked for machine integers");
  }

  template <class R>
  static void taylor_shift(int d, const R& shift, R* out) {
    if (is_exactly_zero(shift)) return;
    while (d > 0 && is_exactly_zero(out[d])) --d;
    for (int k = 0; k < d; ++k) {
      for (int j = d - 1; j >= k; --j) out[j] += shift * out[j + 1];
    }
  }

  Formula formula_;
};

}  // namespace kinex

#endif
