// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/integer.h"

#include <cmath>
#include <limits>

#include "core/numbers/check.h"

namespace kinex {

Integer::Integer(Int128 value) {
  mpz_init(z_);
  const bool negative = value < 0;
  const auto magnitude =
      negative ? -static_cast<unsigned __int128>(value) : static_cast<unsigned __int128>(value);
  const std::uint64_t words[2] = {static_cast<std::uint64_t>(magnitude),
                                  static_cast<std::uint64_t>(magnitude >> 64)};
  mpz_import(z_, 2, -1, sizeof(words[0]), 0, 0, words);
  if (negative) mpz_neg(z_, z_);
}

std::optional<Integer> Integer::from_double(double value) {
  if (!std::isfinite(value) || std::trunc(value) != value) return std::nullopt;
  Integer result;
  mpz_set_d(result.z_, value);
  return result;
}

std::optional<Integer> Integer::parse(std::string_view text) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative || (!text.empty() && text.front() == '+')) text.remove_prefix(1);
  if (text.empty()) return std::nullopt;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
  }
  Integer result;
  if (mpz_set_str(result.z_, std::string(text).c_str(), 10) != 0) return std::nullopt;
  if (negative) result.negate();
  return result;
}

Integer Integer::power_of_two(unsigned long k) {
  Integer result;
  mpz_setbit(result.z_, k);
  return result;
}

double Integer::to_double() const {
  if (bit_length() > 1024) {
    return sign() < 0 ? -std::numeric_limits<double>::infinity()
                      : std::numeric_limits<double>::infinity();
  }
  return mpz_get_d(z_);
}

std::string Integer::to_string() const {
  std::string text(mpz_sizeinbase(z_, 10) + 2, '\0');
  mpz_get_str(text.data(), 10, z_);
  text.resize(text.find('\0'));
  return text;
}

Integer abs(Integer a) {
  if (a.sign() < 0) a.negate();
  return a;
}

Integer gcd(const Integer& a, const Integer& b) {
  Integer result;
  mpz_gcd(result.raw(), a.raw(), b.raw());
  return result;
}

Integer lcm(const Integer& a, const Integer& b) {
  Integer result;
  mpz_lcm(result.raw(), a.raw(), b.raw());
  return result;
}

Integer power(const Integer& base, unsigned long exponent) {
  Integer result;
  mpz_pow_ui(result.raw(), base.raw(), exponent);
  return result;
}

Integer floor_divide(const Integer& a, const Integer& b) {
  require(!b.is_zero(), "floor_divide: division by zero");
  Integer result;
  mpz_fdiv_q(result.raw(), a.raw(), b.raw());
  return result;
}

}  // namespace kinex
