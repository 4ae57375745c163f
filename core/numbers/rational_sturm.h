// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials over the rationals and their Sturm sequences: all root finding of the `sturm`
// arithmetic. The reference for `exact`: plain, and sharing only Integer and Rational with it.
#ifndef KINEX_CORE_NUMBERS_RATIONAL_STURM_H
#define KINEX_CORE_NUMBERS_RATIONAL_STURM_H

#include <cstdint>
#include <vector>

#include "core/numbers/rational.h"
#include "core/numbers/sign.h"
#include "core/numbers/stop.h"

namespace kinex {

// Work counts and a deadline; a plain value owned by the caller and passed by reference.
struct SturmWork {
  std::uint64_t refinements = 0;  // bisections of an isolating interval
  std::uint64_t gcds = 0;
  std::uint64_t max_bits = 0;  // largest numerator or denominator of a coefficient
  Deadline* deadline = nullptr;  // polled in every step that may be long; null: none
};

// Coefficients low degree first, no leading zeros; the zero polynomial has none.
class RationalPolynomial {
 public:
  RationalPolynomial() = default;
  // Leading zeros are stripped.
  explicit RationalPolynomial(std::vector<Rational> coefficients);

  int degree() const { return static_cast<int>(c_.size()) - 1; }  // -1 for zero
  bool is_zero() const { return c_.empty(); }
  const Rational& operator[](std::size_t i) const { return c_[i]; }
  const Rational& leading() const { return c_.back(); }  // requires !is_zero()
  const std::vector<Rational>& coefficients() const { return c_; }

  Rational value_at(const Rational& t) const;
  Sign sign_at(const Rational& t) const { return to_sign(value_at(t).sign()); }
  Sign sign_at_plus_infinity() const { return to_sign(is_zero() ? 0 : leading().sign()); }
  Sign sign_at_minus_infinity() const {
    return degree() % 2 == 0 ? sign_at_plus_infinity() : -sign_at_plus_infinity();
  }
  RationalPolynomial derivative() const;
  // Multiplied by the positive number that makes the coefficients coprime integers: no sign
  // changes, and values at dyadic points stay small. Zero stays zero.
  void normalise();
  std::uint64_t max_bits() const;

  friend RationalPolynomial operator-(RationalPolynomial a);
  friend bool operator==(const RationalPolynomial&, const RationalPolynomial&) = default;

 private:
  std::vector<Rational> c_;
};

// a = quotient * b + remainder, degree(remainder) < degree(b). Requires b != 0. O(d^2) operations.
struct Division {
  RationalPolynomial quotient, remainder;
};
Division divide(const RationalPolynomial& a, const RationalPolynomial& b);

// The gcd up to a positive constant, by Euclid's algorithm; not both zero.
RationalPolynomial gcd(RationalPolynomial a, RationalPolynomial b, SturmWork& work);

// p, p', and the negated remainders, each divided by the last one (the gcd of p and p') and by a
// positive constant. So the first element has the roots of p, each once, and counts are correct at
// every point, multiple roots of p included.
// Source: Sturm's theorem, as in Basu, Pollack, Roy, Algorithms in Real Algebraic Geometry, 2.2.
class RationalSturm {
 public:
  // p not zero.
  RationalSturm(const RationalPolynomial& p, SturmWork& work);

  // The same real roots as p, each once; a positive multiple of p where p is square-free.
  const RationalPolynomial& square_free() const { return sequence_.front(); }
  // Sign changes along the sequence. variations(a) - variations(b) is the number of distinct real
  // roots in (a, b].
  int variations(const Rational& t) const;
  int variations_at_plus_infinity() const;
  int variations_at_minus_infinity() const;
  // Distinct real roots in (a, b]; requires a <= b.
  int count(const Rational& a, const Rational& b) const { return variations(a) - variations(b); }

 private:
  std::vector<RationalPolynomial> sequence_;
  Deadline* deadline_;
};

}  // namespace kinex

#endif
