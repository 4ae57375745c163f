// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/binary_scale.h"

#include <algorithm>

namespace kinex::lab {

namespace {

constexpr long kSmallestExponent = -1022;
constexpr long kFraction = 52;  // bits of a binary64 after the first

}  // namespace

Rational power_of_two(long k) {
  const Integer power = Integer::power_of_two(static_cast<unsigned long>(k < 0 ? -k : k));
  return k < 0 ? Rational(Integer(1), power) : Rational(power);
}

Rational absolute(Rational x) { return x.sign() < 0 ? -std::move(x) : x; }

long floor_log2(const Rational& x) {
  const long k = static_cast<long>(x.numerator().bit_length()) -
                 static_cast<long>(x.denominator().bit_length());
  return power_of_two(k) <= x ? k : k - 1;  // 2^(k-1) < x < 2^(k+1)
}

long ceil_log2(const Rational& x) {
  const long k = floor_log2(x);
  return power_of_two(k) == x ? k : k + 1;
}

Rational round_to_bits(const Rational& x, long bits) {
  if (x.is_zero()) return x;
  const Rational unit = power_of_two(floor_log2(absolute(x)) - bits + 1);
  const Rational scaled = x / unit;
  Integer below = floor_divide(scaled.numerator(), scaled.denominator());
  const Rational rest = scaled - Rational(below);
  const Rational half(Integer(1), Integer(2));
  if (rest > half || (rest == half && !below.is_even())) below += Integer(1);
  return Rational(below) * unit;
}

Rational ulp_of(const Rational& x) {
  const long exponent = x.is_zero() ? kSmallestExponent : floor_log2(absolute(x));
  return power_of_two(std::max(exponent, kSmallestExponent) - kFraction);
}

}  // namespace kinex::lab
