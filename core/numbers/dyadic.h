// SPDX-License-Identifier: GPL-3.0-or-later
// Helpers for numbers numerator / 2^exponent (the exponent may be negative), for real roots.
#ifndef KINEX_CORE_NUMBERS_DYADIC_H
#define KINEX_CORE_NUMBERS_DYADIC_H

#include <optional>

#include "core/numbers/polynomial.h"

namespace kinex {

inline Rational dyadic(const Integer& numerator, long exponent) {  // numerator / 2^exponent
  Rational result(numerator);
  if (exponent >= 0) {
    mpq_div_2exp(result.edit(), result.raw(), static_cast<unsigned long>(exponent));
  } else {
    mpq_mul_2exp(result.edit(), result.raw(), static_cast<unsigned long>(-exponent));
  }
  return result;
}

// The integer part (floor) of value * 2^k; k may be negative.
inline Integer scaled_by_power(Integer value, long k) {
  if (k >= 0) {
    value <<= static_cast<unsigned long>(k);
  } else {
    value >>= static_cast<unsigned long>(-k);
  }
  return value;
}

// -1, 0 or 1: the sign of a / 2^a_exponent - b / 2^b_exponent. Exact; one shift at most.
inline int compare_dyadic(const Integer& a, long a_exponent, const Integer& b, long b_exponent) {
  if (a.sign() != b.sign()) return a.sign() < b.sign() ? -1 : 1;
  if (a_exponent == b_exponent) return to_int(to_sign(mpz_cmp(a.raw(), b.raw())));
  if (a_exponent < b_exponent) {
    return to_int(to_sign(mpz_cmp(scaled_by_power(a, b_exponent - a_exponent).raw(), b.raw())));
  }
  return to_int(to_sign(mpz_cmp(a.raw(), scaled_by_power(b, a_exponent - b_exponent).raw())));
}

// The sign of p at numerator / 2^exponent. Exact; kZero only at a root.
inline Sign sign_at_dyadic(const Polynomial& p, const Integer& numerator, long exponent) {
  if (exponent >= 0) return p.sign_at_dyadic(numerator, static_cast<unsigned long>(exponent));
  return p.sign_at_dyadic(numerator << static_cast<unsigned long>(-exponent), 0);
}

// The least e >= 0 for which value * 2^e is an integer. Requires a dyadic value.
inline long dyadic_exponent(const Rational& value) {
  return static_cast<long>(mpz_scan1(mpq_denref(value.raw()), 0));
}

// The sign that q has everywhere on [lower, upper] / 2^exponent, proved by interval arithmetic
// (Horner's rule); nullopt if that does not decide. Never kZero. Requires lower <= upper and q not
// zero. Cost: two products of integers per degree.
std::optional<Sign> sign_on_interval(const Polynomial& q, Integer lower, Integer upper,
                                     long exponent);

}  // namespace kinex

#endif
