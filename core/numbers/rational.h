// SPDX-License-Identifier: GPL-3.0-or-later
// Rational: exact fractions, always canonical (gcd 1, positive denominator). Wraps GMP's mpq.
//
// A fraction of two words is kept within the object and computed with machine integers: audits of small scenes have
// no others. Cost: no allocation and at most two common divisors of words for each operation then; otherwise that of mpq,
// and copies of operands that are words. The shares: sh experiments/bench/run fractions.
#ifndef KINEX_CORE_NUMBERS_RATIONAL_H
#define KINEX_CORE_NUMBERS_RATIONAL_H

#include <gmp.h>

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/numbers/integer.h"

namespace kinex {

class Rational {
 public:
  Rational() { keep_within(0, 0, 1); }
  Rational(int value) : Rational(static_cast<std::int64_t>(value)) {}  // NOLINT: exact
  Rational(std::int64_t value) { keep_within(signed_size(value), size_of(value), 1); }  // NOLINT
  Rational(const Integer& value);                                                       // NOLINT
  // numerator / denominator, reduced; requires denominator != 0.
  Rational(const Integer& numerator, const Integer& denominator);
  Rational(const Rational& other) {
    if (other.has_words()) {
      keep_words_of(other);
    } else {
      copy_beyond(other);
    }
  }
  Rational(Rational&& other) noexcept { take_over(other); }
  Rational& operator=(const Rational& other) {
    if (is_within() && other.has_words()) {
      keep_words_of(other);
    } else {
      mpq_set(edit(), other.q_);
    }
    return *this;
  }
  Rational& operator=(Rational&& other) noexcept {
    if (!is_within() && !other.is_within()) {
      mpq_swap(q_, other.q_);
    } else if (this != &other) {
      if (!is_within()) mpq_clear(q_);
      take_over(other);
    }
    return *this;
  }
  ~Rational() {
    if (!is_within()) mpq_clear(q_);
  }
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

  Rational& operator+=(const Rational& b);
  Rational& operator-=(const Rational& b);
  Rational& operator*=(const Rational& b);
  // Requires b != 0.
  Rational& operator/=(const Rational& b);
  friend Rational operator+(Rational a, const Rational& b) { a += b; return a; }
  friend Rational operator-(Rational a, const Rational& b) { a -= b; return a; }
  friend Rational operator*(Rational a, const Rational& b) { a *= b; return a; }
  friend Rational operator/(Rational a, const Rational& b) { a /= b; return a; }
  friend Rational operator-(Rational a) {
    mpz_neg(mpq_numref(a.q_), mpq_numref(a.q_));  // in place: its sign alone
    return a;
  }
  friend bool operator==(const Rational& a, const Rational& b) { return mpq_equal(a.q_, b.q_) != 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    Words u, v;
    if (!a.read(u) || !b.read(v)) return mpq_cmp(a.q_, b.q_) <=> 0;
    if (u.denominator == v.denominator) return u.numerator <=> v.numerator;
    return Int128{u.numerator} * v.denominator <=> Int128{v.numerator} * u.denominator;
  }

  // = numerator / denominator, which are in lowest terms; numerator > -2^63, denominator > 0. No allocation.
  void set_words(std::int64_t numerator, std::int64_t denominator) {
    keep({numerator, denominator});
  }

  // To read. What it points to is gone when the number changes, moves or ends.
  mpq_srcptr raw() const { return q_; }
  // To write by GMP's functions, which may allocate. The result must be canonical.
  mpq_ptr edit() {
    if (is_within()) move_out();
    return q_;
  }

 private:
  struct Words {  // in lowest terms; numerator > -2^63, denominator > 0
    std::int64_t numerator, denominator;
  };

  // GMP's headers of the numbers within: they have room for no more (MPZ_ROINIT_N), so GMP only reads them.
  void keep_within(int size, mp_limb_t numerator, mp_limb_t denominator) {
    limbs_[0] = numerator;
    limbs_[1] = denominator;
    const mpz_t above = MPZ_ROINIT_N(limbs_, size), below = MPZ_ROINIT_N(limbs_ + 1, 1);
    *mpq_numref(q_) = *above;
    *mpq_denref(q_) = *below;
  }
  bool is_within() const { return mpq_denref(q_)->_mp_d == limbs_ + 1; }
  // Each part is one word, within or not.
  bool has_words() const { return mpz_size(mpq_numref(q_)) <= 1 && mpz_size(mpq_denref(q_)) == 1; }
  bool read(Words& out) const {
    if (!has_words()) return false;
    const mp_limb_t n = mpz_getlimbn(mpq_numref(q_), 0), d = mpz_getlimbn(mpq_denref(q_), 0);
    if (((n | d) >> 63) != 0) return false;
    const auto magnitude = static_cast<std::int64_t>(n);
    out = {sign() < 0 ? -magnitude : magnitude, static_cast<std::int64_t>(d)};
    return true;
  }
  void keep(const Words& words) {
    if (!is_within()) mpq_clear(q_);
    keep_within(signed_size(words.numerator), size_of(words.numerator),
                static_cast<mp_limb_t>(words.denominator));
  }
  static int signed_size(std::int64_t value) { return value < 0 ? -1 : value > 0 ? 1 : 0; }
  static mp_limb_t size_of(std::int64_t value) {
    return value < 0 ? mp_limb_t{0} - static_cast<mp_limb_t>(value) : static_cast<mp_limb_t>(value);
  }
  void keep_words_of(const Rational& other) {
    keep_within(other.sign(), mpz_getlimbn(mpq_numref(other.q_), 0),
                mpz_getlimbn(mpq_denref(other.q_), 0));
  }
  // Of an object that has no number yet; leaves 0.
  void take_over(Rational& other) noexcept {
    if (other.is_within()) {
      keep_words_of(other);
    } else {
      *q_ = *other.q_;
      other.keep_within(0, 0, 1);
    }
  }
  void copy_beyond(const Rational& other);
  void move_out();
  void move_in();  // if its parts are words
  // Words of the result, if they are.
  static bool sum(const Words& a, const Words& b, Words& out);
  static bool product(const Words& a, const Words& b, Words& out);

  mpq_t q_;             // its limbs are `limbs_` or GMP's
  mp_limb_t limbs_[2];  // numerator, denominator
};

// Decimal digits of `value`, rounded towards zero, with `digits` digits after the point.
std::string decimal(const Rational& value, int digits);

}  // namespace kinex

#endif
