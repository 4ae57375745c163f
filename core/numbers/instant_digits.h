// SPDX-License-Identifier: GPL-3.0-or-later
// The leading digits of an instant, binary and decimal: the same for every representation of it.
//
//   decimal  |t| truncated to kDecimalDigits significant digits. Written with a point where
//            10^-5 <= |t| < 10^12 ("0.0507768179285"), else as d.ddddddddddde-320; zero is "0".
//   binary   the cell [m, m + 1] 2^e with 2^(bits - 1) <= m < 2^bits that contains |t|, its lower
//            end included
#ifndef KINEX_CORE_NUMBERS_INSTANT_DIGITS_H
#define KINEX_CORE_NUMBERS_INSTANT_DIGITS_H

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/numbers/rational.h"

namespace kinex {

inline constexpr int kDecimalDigits = 12;  // significant digits of a decimal
// Significant bits of the interval for InstantDetail::kInterval.
inline constexpr int kIntervalBits = 40;

struct DyadicCell {  // [mantissa, mantissa + 1] 2^exponent
  Integer mantissa;
  long exponent = 0;
};

// The closed interval +-[m, m + 1] 2^e. Reuses the memory of the two results.
void set_interval(const DyadicCell& cell, bool negative, Rational& lower, Rational& upper);

// The decimal of +-[n, n + 1) 10^exponent, where n has kDecimalDigits digits.
void write_digits(std::string& out, bool negative, std::uint64_t digits, long exponent);
void set_decimal(std::string& out, const Rational& value);

// The closed interval of the numbers with the decimal `text`; nullopt if it is not a decimal of
// this form. Except for zero, the end farther from zero does not itself have this decimal.
struct DecimalRange {
  Rational lower, upper;
};
std::optional<DecimalRange> decimal_range(std::string_view text);

// From doubles around the instant (lo <= hi); false if they do not determine the result.
bool set_decimal(std::string& out, double lo, double hi);
bool set_interval(double lo, double hi, Rational& lower, Rational& upper);

// ---- Exactly, for an instant t with rational ends lower() <= t <= upper(), equal once t is known
// to be rational. `compare` gives the order of t and a rational; `refine` narrows the interval.

namespace digits {

Integer floor_of(const Rational& value);  // the largest integer <= value
Rational power_of(int base, long exponent);  // base^exponent
// The largest e with base^e <= value, off by at most one. Requires value > 0.
long estimate_exponent(int base, const Rational& value);

// floor(|t| scale).
template <class Instant, class Compare, class Refine>
Integer floor_of_scaled(Instant& t, bool negative, const Rational& scale, const Compare& compare,
                        const Refine& refine) {
  for (;;) {
    const Rational near = (negative ? -t.upper() : t.lower()) * scale;
    const Rational far = (negative ? -t.lower() : t.upper()) * scale;
    const Integer low = floor_of(near), high = floor_of(far);
    if (low == high) return low;
    if (high == low + Integer(1)) {
      const Rational between = Rational(high) / scale;
      const int order = negative ? -compare(-between) : compare(between);
      return order < 0 ? low : high;
    }
    refine();
  }
}

// floor(|t| / base^e) and e, for the e that gives `digits` digits.
template <class Instant, class Compare, class Refine>
DyadicCell leading(Instant& t, bool negative, int base, long digits, const Compare& compare,
                   const Refine& refine) {
  const Rational least = power_of(base, digits - 1), most = power_of(base, digits);
  // Terminates because t is not zero.
  while ((negative ? t.upper() : t.lower()).is_zero()) refine();
  for (long e = estimate_exponent(base, negative ? -t.upper() : t.lower()) - digits + 1;;) {
    Integer n = floor_of_scaled(t, negative, power_of(base, -e), compare, refine);
    if (Rational(n) >= most) {
      ++e;
    } else if (Rational(n) < least) {
      --e;
    } else {
      return {std::move(n), e};
    }
  }
}

}  // namespace digits

// The sign of t: refines until both ends agree.
template <class Instant, class Compare, class Refine>
int sign_of_instant(Instant& t, const Compare& compare, const Refine& refine) {
  if (t.lower().sign() > 0) return 1;
  if (t.upper().sign() < 0) return -1;
  const int sign = compare(Rational());
  while (sign != 0 && t.lower().sign() * t.upper().sign() < 0) refine();
  return sign;
}

template <class Instant, class Compare, class Refine>  // the decimal of t
void set_exact_decimal(std::string& out, Instant& t, const Compare& compare, const Refine& refine) {
  const int sign = sign_of_instant(t, compare, refine);
  if (sign == 0) {
    out = "0";
    return;
  }
  const DyadicCell n = digits::leading(t, sign < 0, 10, kDecimalDigits, compare, refine);
  write_digits(out, sign < 0, static_cast<std::uint64_t>(n.mantissa.to_int64()), n.exponent);
}

// The cell of `bits` significant bits that contains t. Requires t != 0.
template <class Instant, class Compare, class Refine>
DyadicCell leading_bits(Instant& t, long bits, const Compare& compare, const Refine& refine) {
  return digits::leading(t, sign_of_instant(t, compare, refine) < 0, 2, bits, compare, refine);
}

template <class Instant, class Compare, class Refine>  // its cell of kIntervalBits bits
void set_exact_interval(Instant& t, const Compare& compare, const Refine& refine, Rational& lower,
                        Rational& upper) {
  const int sign = sign_of_instant(t, compare, refine);
  if (sign == 0) {
    lower = upper = Rational();
    return;
  }
  set_interval(leading_bits(t, kIntervalBits, compare, refine), sign < 0, lower, upper);
}

}  // namespace kinex

#endif
