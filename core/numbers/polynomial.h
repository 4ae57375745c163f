// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomial: dense univariate polynomials with Integer coefficients, low degree first.
// Invariant: the leading coefficient is not zero; the zero polynomial has no coefficients.
#ifndef KINEX_CORE_NUMBERS_POLYNOMIAL_H
#define KINEX_CORE_NUMBERS_POLYNOMIAL_H

#include <cstddef>
#include <string>
#include <vector>

#include "core/numbers/integer.h"
#include "core/numbers/rational.h"
#include "core/numbers/sign.h"

namespace kinex {

class Polynomial {
 public:
  Polynomial() = default;
  // Leading zeros are stripped.
  explicit Polynomial(std::vector<Integer> coefficients);
  // The primitive integer polynomial that is a positive multiple of sum coefficients[i] t^i.
  static Polynomial from_rationals(const std::vector<Rational>& coefficients);

  int degree() const { return static_cast<int>(c_.size()) - 1; }  // -1 for zero
  bool is_zero() const { return c_.empty(); }
  const Integer& operator[](std::size_t i) const { return c_[i]; }
  const Integer& leading() const { return c_.back(); }  // requires !is_zero()
  const std::vector<Integer>& coefficients() const { return c_; }
  // Largest bit length of a coefficient; 0 for zero.
  std::size_t max_bits() const;

  Polynomial derivative() const;
  // Sign of the value at t (exact). Cost O(d) products of growing size.
  Sign sign_at(const Rational& t) const;
  // Sign of the value at numerator / 2^exponent.
  Sign sign_at_dyadic(const Integer& numerator, unsigned long exponent) const;
  // The value at numerator / 2^exponent, times 2^(exponent * degree()).
  Integer scaled_value_at_dyadic(const Integer& numerator, unsigned long exponent) const;
  Rational value_at(const Rational& t) const;
  // Sign for t -> +infinity and t -> -infinity.
  Sign sign_at_plus_infinity() const;
  Sign sign_at_minus_infinity() const;
  // gcd of the coefficients, >= 0.
  Integer content() const;
  // Divided by the content; the sign is kept.
  Polynomial primitive_part() const;
  // Primitive with positive leading coefficient: one name per polynomial up to a constant factor.
  Polynomial canonical() const;

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a);
  friend bool operator==(const Polynomial& a, const Polynomial& b) = default;

  // "c0 c1 .. cd", for messages.
  std::string to_string() const;

 private:
  void strip();
  std::vector<Integer> c_;
};

}  // namespace kinex

#endif
