// SPDX-License-Identifier: GPL-3.0-or-later
// Integer: arbitrary-precision signed integers. GMP's mpz is wrapped here and nowhere else.
#ifndef KINEX_CORE_NUMBERS_INTEGER_H
#define KINEX_CORE_NUMBERS_INTEGER_H

#include <gmp.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kinex {

using Int128 = __int128;  // 128 bits; intermediate results

// A value type: every operator returns an Integer (no expression templates leak into `auto`).
// Cost: one allocation per non-zero value; additions are linear and products M(bits).
class Integer {
 public:
  Integer() { mpz_init(z_); }
  Integer(int value) { mpz_init_set_si(z_, value); }           // NOLINT: an int is exact
  Integer(std::int64_t value) { mpz_init_set_si(z_, value); }  // NOLINT
  explicit Integer(Int128 value);
  Integer(const Integer& other) { mpz_init_set(z_, other.z_); }
  Integer(Integer&& other) noexcept {
    mpz_init(z_);
    mpz_swap(z_, other.z_);
  }
  Integer& operator=(const Integer& other) {
    mpz_set(z_, other.z_);
    return *this;
  }
  Integer& operator=(Integer&& other) noexcept {
    mpz_swap(z_, other.z_);
    return *this;
  }
  ~Integer() { mpz_clear(z_); }
  Integer(double) = delete;  // 0.1 is not an integer; see from_double

  // The integer equal to `value`; nullopt if value is not finite or not integral.
  static std::optional<Integer> from_double(double value);
  // Decimal digits with an optional sign, nothing else; nullopt otherwise.
  static std::optional<Integer> parse(std::string_view text);
  // 2^k, k >= 0.
  static Integer power_of_two(unsigned long k);

  int sign() const { return mpz_sgn(z_); }
  bool is_zero() const { return mpz_sgn(z_) == 0; }
  bool is_even() const { return mpz_even_p(z_) != 0; }
  // Number of bits of |value|; 0 for 0.
  std::size_t bit_length() const { return is_zero() ? 0 : mpz_sizeinbase(z_, 2); }
  // Number of trailing zero bits of |value|; 0 for 0.
  std::size_t trailing_zeros() const { return is_zero() ? 0 : mpz_scan1(z_, 0); }
  bool fits_int64() const { return mpz_fits_slong_p(z_) != 0; }
  std::int64_t to_int64() const { return mpz_get_si(z_); }  // requires fits_int64()
  // Truncated towards zero to 53 bits; +-inf beyond the range of double.
  double to_double() const;
  std::string to_string() const;

  Integer& operator+=(const Integer& b) { mpz_add(z_, z_, b.z_); return *this; }
  Integer& operator-=(const Integer& b) { mpz_sub(z_, z_, b.z_); return *this; }
  Integer& operator*=(const Integer& b) { mpz_mul(z_, z_, b.z_); return *this; }
  Integer& operator<<=(unsigned long k) { mpz_mul_2exp(z_, z_, k); return *this; }
  // Floor division by 2^k.
  Integer& operator>>=(unsigned long k) { mpz_fdiv_q_2exp(z_, z_, k); return *this; }
  // *this += a * b and *this -= a * b without a temporary.
  void add_product(const Integer& a, const Integer& b) { mpz_addmul(z_, a.z_, b.z_); }
  void subtract_product(const Integer& a, const Integer& b) { mpz_submul(z_, a.z_, b.z_); }
  void negate() { mpz_neg(z_, z_); }
  // *this / b; requires b != 0 and b divides *this.
  void divide_exactly(const Integer& b) { mpz_divexact(z_, z_, b.z_); }

  friend Integer operator+(Integer a, const Integer& b) { a += b; return a; }
  friend Integer operator-(Integer a, const Integer& b) { a -= b; return a; }
  friend Integer operator*(const Integer& a, const Integer& b) {
    Integer r;
    mpz_mul(r.z_, a.z_, b.z_);
    return r;
  }
  friend Integer operator<<(Integer a, unsigned long k) { a <<= k; return a; }
  friend Integer operator>>(Integer a, unsigned long k) { a >>= k; return a; }
  friend Integer operator-(Integer a) { a.negate(); return a; }
  friend bool operator==(const Integer& a, const Integer& b) { return mpz_cmp(a.z_, b.z_) == 0; }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
    return mpz_cmp(a.z_, b.z_) <=> 0;
  }

  // Read and write access to GMP, for core/ only.
  mpz_srcptr raw() const { return z_; }
  mpz_ptr raw() { return z_; }

 private:
  mpz_t z_;
};

Integer abs(Integer a);  // |a|
Integer gcd(const Integer& a, const Integer& b);  // >= 0; gcd(0, 0) = 0
Integer lcm(const Integer& a, const Integer& b);  // >= 0
Integer power(const Integer& base, unsigned long exponent);  // base^exponent
Integer floor_divide(const Integer& a, const Integer& b);  // requires b != 0

}  // namespace kinex

#endif
