// SPDX-License-Identifier: GPL-3.0-or-later
// Rational: exact fractions, always canonical (gcd 1, positive denominator). Wraps GMP's mpq.
#ifndef KINEX_CORE_NUMBERS_RATIONAL_H
#define KINEX_CORE_NUMBERS_RATIONAL_H

#include <gmp.h>

#include <compare>
#include <optional>
#include <string>
#include <string_view>

#include "core/numbers/integer.h"

namespace kinex {

class Rational {
 public:
  Rational() { mpq_init(q_); }
  Rational(int value) : Rational() { mpq_set_si(q_, value, 1); }           // NOLINT: exact
  Rational(std::int64_t value) : Rational() { mpq_set_si(q_, value, 1); }  // NOLINT
  Rational(const Integer& value) : Rational() { mpq_set_z(q_, value.raw()); }  // NOLINT
  // numerator / denominator, reduced; requires denominator != 0.
  Rational(const Integer& numerator, const Integer& denominator);
  Rational(const Rational& other) : Rational() { mpq_set(q_, other.q_); }
  Rational(Rational&& other) noexcept : Rational() { mpq_swap(q_, other.q_); }
  Rational& operator=(const Rational& other) { mpq_set(q_, other.q_); return *this; }
  Rational& operator=(Rational&& other) noexcept { mpq_swap(q_, other.q_); return *this; }
  ~Rational() { mpq_clear(q_); }
  Rational(double) = delete;  // a binary64 is read with from_double, on purpose

  // Exactly the binary64 `value`; nullopt for NaN and infinities.
  static std::optional<Rational> from_double(double value);

  // What a number in an input file may look like; nullopt if `text` is none of these:
  //   [+-]digits                      "-7"
  //   [+-]digits/digits               "1/3"   (denominator not zero)
  //   decimal, optional exponent      "0.1" = 1/10, "1e-300", ".5", "2."
  //   hexadecimal binary64            "0x1.8p+3" = 12
  // Exponents beyond kMaxExponent in absolute value are refused: the numbers would exhaust memory.
  static constexpr long kMaxExponent = 100000;
  static std::optional<Rational> parse(std::string_view text);

  Integer numerator() const;
  Integer denominator() const;  // > 0
  int sign() const { return mpq_sgn(q_); }
  bool is_zero() const { return sign() == 0; }
  bool is_integer() const { return mpz_cmp_ui(mpq_denref(q_), 1) == 0; }
  bool is_dyadic() const;  // the denominator is a power of two
  // The largest double <= value and the smallest double >= value (+-inf where there is none).
  double lower_double() const;
  double upper_double() const;
  // A nearest double (within one unit in the last place).
  double to_double() const;
  // "p" or "p/q", canonical.
  std::string to_string() const;

  Rational& operator+=(const Rational& b) { mpq_add(q_, q_, b.q_); return *this; }
  Rational& operator-=(const Rational& b) { mpq_sub(q_, q_, b.q_); return *this; }
  Rational& operator*=(const Rational& b) { mpq_mul(q_, q_, b.q_); return *this; }
  // Requires b != 0.
  Rational& operator/=(const Rational& b) { mpq_div(q_, q_, b.q_); return *this; }
  friend Rational operator+(Rational a, const Rational& b) { a += b; return a; }
  friend Rational operator-(Rational a, const Rational& b) { a -= b; return a; }
  friend Rational operator*(Rational a, const Rational& b) { a *= b; return a; }
  friend Rational operator/(Rational a, const Rational& b) { a /= b; return a; }
  friend Rational operator-(Rational a) { mpq_neg(a.q_, a.q_); return a; }
  friend bool operator==(const Rational& a, const Rational& b) { return mpq_equal(a.q_, b.q_) != 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return mpq_cmp(a.q_, b.q_) <=> 0;
  }

  mpq_srcptr raw() const { return q_; }
  mpq_ptr raw() { return q_; }

 private:
  mpq_t q_;
};

// Decimal digits of `value`, rounded towards zero, with `digits` digits after the point.
std::string decimal(const Rational& value, int digits);

}  // namespace kinex

#endif
