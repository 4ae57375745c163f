// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/instant_digits.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace kinex {

namespace {

// The decimals that are written with a point.
constexpr long kLeastPlain = -5, kMostPlain = kDecimalDigits - 1;
// Powers of ten that are doubles.
constexpr int kExactTens = 22;
constexpr std::array<double, kExactTens + 1> kTens = [] {
  std::array<double, kExactTens + 1> powers{};
  double power = 1;
  for (double& p : powers) {
    p = power;
    power *= 10;
  }
  return powers;
}();
constexpr double kLeastDigits = 1e11;  // 10^(kDecimalDigits - 1)

void set_dyadic(Rational& out, const Integer& mantissa, long exponent) {
  mpq_set_z(out.edit(), mantissa.raw());
  if (exponent >= 0) {
    mpq_mul_2exp(out.edit(), out.raw(), static_cast<unsigned long>(exponent));
  } else {
    mpq_div_2exp(out.edit(), out.raw(), static_cast<unsigned long>(-exponent));
  }
}

}  // namespace

void set_interval(const DyadicCell& cell, bool negative, Rational& lower, Rational& upper) {
  Rational& near = negative ? upper : lower;
  Rational& far = negative ? lower : upper;
  set_dyadic(near, cell.mantissa, cell.exponent);
  Integer next = cell.mantissa;
  mpz_add_ui(next.raw(), next.raw(), 1);
  set_dyadic(far, next, cell.exponent);
  if (!negative) return;
  near = -std::move(near);
  far = -std::move(far);
}

void write_digits(std::string& out, bool negative, std::uint64_t digits, long exponent) {
  std::array<char, 24> buffer;
  const char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), digits).ptr;
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  const long leading = exponent + kDecimalDigits - 1;  // 10^leading <= |value|
  out.clear();
  if (negative) out += '-';
  if (leading < kLeastPlain || leading > kMostPlain) {
    out += text[0];
    out += '.';
    out += text.substr(1);
    out += 'e';
    std::array<char, 24> power;
    out.append(power.data(), std::to_chars(power.data(), power.data() + power.size(), leading).ptr);
    return;
  }
  if (leading < 0) {
    out += "0.";
    out.append(static_cast<std::size_t>(-leading - 1), '0');
    out += text;
    return;
  }
  const auto whole = static_cast<std::size_t>(leading) + 1;
  out += text.substr(0, whole);
  if (whole == text.size()) return;
  out += '.';
  out += text.substr(whole);
}

namespace {

// In machine integers; false if they overflow.
bool set_short_decimal(std::string& out, const Rational& value) {
  const mpz_srcptr numerator = mpq_numref(value.raw()), denominator = mpq_denref(value.raw());
  if (mpz_sizeinbase(numerator, 2) > 60 || mpz_sizeinbase(denominator, 2) > 60) return false;
  const auto n = mpz_get_ui(numerator), d = mpz_get_ui(denominator);  // of the absolute value
  const double about = static_cast<double>(n) / static_cast<double>(d);
  constexpr long kMostShift = 19;  // 2^60 10^19 < 2^124
  for (long leading = std::lround(std::floor(std::log10(about)));;) {
    const long shift = kDecimalDigits - 1 - leading;
    if (shift > kMostShift || shift < -kMostShift) return false;
    using Wide = unsigned __int128;
    Wide ten = 1;
    for (long i = 0; i < std::labs(shift); ++i) ten *= 10;
    const Wide digits = shift >= 0 ? n * ten / d : n / (d * ten);
    if (digits >= static_cast<Wide>(10 * kLeastDigits)) {
      ++leading;
    } else if (digits < static_cast<Wide>(kLeastDigits)) {
      --leading;
    } else {
      write_digits(out, value.sign() < 0, static_cast<std::uint64_t>(digits), -shift);
      return true;
    }
  }
}

}  // namespace

void set_decimal(std::string& out, const Rational& value) {
  if (!value.is_zero() && set_short_decimal(out, value)) return;
  struct Point {
    const Rational& value;
    const Rational& lower() const { return value; }
    const Rational& upper() const { return value; }
  } point{value};
  const auto compare = [&](const Rational& t) { return value < t ? -1 : t < value ? 1 : 0; };
  set_exact_decimal(out, point, compare, [] {});
}

bool set_decimal(std::string& out, double lo, double hi) {
  const bool negative = hi < 0;
  const double near = negative ? -hi : lo;
  const double far = negative ? -lo : hi;
  if (!(near > 1e-10 && far < 1e22)) return false;
  int leading = static_cast<int>(std::floor(std::ilogb(near) * 0.30102999566398120));
  const auto power = [](double x, int e) {
    return e >= 0 ? x * kTens[static_cast<std::size_t>(e)]
                  : x / kTens[static_cast<std::size_t>(-e)];
  };
  if (power(near, -leading) >= 10) ++leading;
  const int exponent = leading - (kDecimalDigits - 1);
  if (-exponent > kExactTens) return false;
  // One rounding each, of numbers below 2^40: off by less than 2^-13.
  const double low = power(near, -exponent) - 0x1p-12;
  const double high = power(far, -exponent) + 0x1p-12;
  if (!(low >= kLeastDigits && high < 10 * kLeastDigits)) return false;
  const auto digits = static_cast<std::uint64_t>(low);
  if (digits != static_cast<std::uint64_t>(high)) return false;
  write_digits(out, negative, digits, exponent);
  return true;
}

bool set_interval(double lo, double hi, Rational& lower, Rational& upper) {
  const bool negative = hi < 0;
  const double near = negative ? -hi : lo;
  const double far = negative ? -lo : hi;
  if (!(near > 0x1p-1000 && far < 0x1p1000)) return false;
  const long exponent = std::ilogb(near) - (kIntervalBits - 1);
  const double low = std::floor(std::ldexp(near, static_cast<int>(-exponent)));
  if (low != std::floor(std::ldexp(far, static_cast<int>(-exponent)))) return false;
  set_interval({Integer(static_cast<std::int64_t>(low)), exponent}, negative, lower, upper);
  return true;
}

std::optional<DecimalRange> decimal_range(std::string_view text) {
  if (text == "0") return DecimalRange{};
  const std::optional<Rational> value = Rational::parse(text);
  if (!value || value->is_zero()) return std::nullopt;
  // Only the canonical form of a number is accepted.
  std::string canonical;
  set_decimal(canonical, *value);
  if (canonical != text) return std::nullopt;
  Rational size = value->sign() < 0 ? -*value : *value;
  long leading = digits::estimate_exponent(10, size) - 1;
  while (digits::power_of(10, leading + 1) <= size) ++leading;
  const Rational unit = digits::power_of(10, leading - (kDecimalDigits - 1));
  if (value->sign() < 0) return DecimalRange{*value - unit, *value};
  return DecimalRange{*value, *value + unit};
}

namespace digits {

Integer floor_of(const Rational& value) {
  Integer result;
  mpz_fdiv_q(result.raw(), mpq_numref(value.raw()), mpq_denref(value.raw()));
  return result;
}

Rational power_of(int base, long exponent) {
  const Integer p =
      power(Integer(base), static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(Integer(1), p) : Rational(p);
}

long estimate_exponent(int base, const Rational& value) {
  const auto bits = [](mpz_srcptr z) { return static_cast<long>(mpz_sizeinbase(z, 2)); };
  const long twos = bits(mpq_numref(value.raw())) - bits(mpq_denref(value.raw()));
  if (base == 2) return twos;
  return static_cast<long>(std::floor(static_cast<double>(twos) / std::log2(base)));
}

}  // namespace digits

}  // namespace kinex
