// SPDX-License-Identifier: GPL-3.0-or-later
// SturmInstant: an instant of the `sturm` arithmetic: a rational number, or a square-free
// polynomial over the rationals with an interval that isolates one of its roots.
#ifndef KINEX_CORE_ARITHMETIC_STURM_INSTANT_H
#define KINEX_CORE_ARITHMETIC_STURM_INSTANT_H

#include <optional>

#include "core/numbers/rational_sturm.h"

namespace kinex {

// Invariant, one of:
//   rational  lower() == upper() == the number; polynomial() is t - number
//   isolated  polynomial() is square-free, has opposite non-zero signs at lower() < upper(), and
//             exactly one root between them
class SturmInstant {
 public:
  explicit SturmInstant(const Rational& value);
  // Requires the second invariant; a polynomial of degree 1 gives a rational.
  SturmInstant(RationalPolynomial polynomial, Rational lower, Rational upper);

  bool is_rational() const { return rational_; }
  const RationalPolynomial& polynomial() const { return polynomial_; }
  const Rational& lower() const { return lower_; }
  const Rational& upper() const { return upper_; }

  // The number of bisections of the interval.
  int bisections() const { return bisections_; }
  // Bisects the interval at a dyadic point. If the point is the root, the instant becomes rational.
  void refine(SturmWork& work);
  // Narrows the interval until t is not strictly inside it; exact comparison with t: -1, 0, +1.
  int compare(const Rational& t);

 private:
  void become(const Rational& value);

  RationalPolynomial polynomial_;
  Rational lower_, upper_;
  Sign sign_at_lower_ = Sign::kZero;  // of the polynomial; kZero when rational
  bool rational_ = false;
  int bisections_ = 0;
};

// -1, 0, +1: exact. Equality is proved by a root of the gcd in the overlap of the intervals.
// Intervals that are already narrow enough are not narrowed for that, so instants with many equals
// stay short.
int compare(SturmInstant& a, SturmInstant& b, SturmWork& work);

// Sign of p on (x, x + eps), where `sturm` is the sequence of p. p not zero. Afterwards p has no
// root in (x, x.upper()].
Sign sign_after(const RationalPolynomial& p, const RationalSturm& sturm, SturmInstant& x,
                SturmWork& work);

// True if p(x) = 0. p not zero.
bool vanishes_at(const RationalPolynomial& p, const SturmInstant& x, SturmWork& work);

// The first root of p beyond `from` and at most `until` (no limit if nullopt) where p turns from +
// to -. Requires: p positive right after `from`. Doubles a step until it contains a root, then
// bisects until it contains one: the 1998 report, section 10.
std::optional<SturmInstant> first_failure_after(const RationalPolynomial& p,
                                                const RationalSturm& sturm, const Rational& from,
                                                const std::optional<Rational>& until,
                                                SturmWork& work);

// A dyadic number in the middle half of [a, b]. Requires a < b.
Rational dyadic_near_middle(const Rational& a, const Rational& b);

}  // namespace kinex

#endif
