// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/rational.h"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/short_rational.h"

namespace kinex {

namespace {

constexpr mpfr_prec_t kDoubleBits = 53;

// Of words, the second one positive: GMP's is written in assembly.
std::int64_t common_divisor(std::int64_t a, std::int64_t b) {
  if (a == 0 || b == 1) return b;
  const auto size = static_cast<mp_limb_t>(a < 0 ? -a : a);
  return static_cast<std::int64_t>(mpn_gcd_1(&size, 1, static_cast<mp_limb_t>(b)));
}

// A quotient without remainder.
std::int64_t over(std::int64_t a, std::int64_t divisor) { return divisor == 1 ? a : a / divisor; }

// A fraction of words, if both are: of each less than 2^63.
bool fits(Int128 numerator, Int128 denominator, std::int64_t& n, std::int64_t& d) {
  constexpr Int128 kMost = std::numeric_limits<std::int64_t>::max();
  if (numerator > kMost || numerator < -kMost || denominator > kMost) return false;
  n = static_cast<std::int64_t>(numerator);
  d = static_cast<std::int64_t>(denominator);
  return true;
}

// The numerator and the denominator as integers of at most 53 bits; false if they are longer.
bool are_short(mpq_srcptr value, std::int64_t& n, std::int64_t& d) {
  const auto is_short = [](mpz_srcptr z) {
    return mpz_size(z) <= 1 && (mpz_getlimbn(z, 0) >> kDoubleBits) == 0;
  };
  if (!is_short(mpq_numref(value)) || !is_short(mpq_denref(value))) return false;
  n = mpz_get_si(mpq_numref(value));
  d = mpz_get_si(mpq_denref(value));
  return true;
}

// A quotient of integers of at most 53 bits: the division of doubles rounds to nearest, and the
// exact remainder tells to which side.
double rounded_quotient(std::int64_t n, std::int64_t d, mpfr_rnd_t mode) {
  const double q = static_cast<double>(n) / static_cast<double>(d);
  if (d == 1 || mode == MPFR_RNDN) return q;
  // q = m 2^-e with 0 <= e: |q| < 2^53. n 2^e and m d are below 2^108.
  int exponent = 0;
  const double fraction = std::frexp(q, &exponent);
  const auto m = static_cast<std::int64_t>(std::ldexp(fraction, kDoubleBits));
  const Int128 rest = n * (Int128{1} << (kDoubleBits - exponent)) - static_cast<Int128>(m) * d;
  if (mode == MPFR_RNDD && rest < 0) return std::nextafter(q, -HUGE_VAL);
  if (mode == MPFR_RNDU && rest > 0) return std::nextafter(q, HUGE_VAL);
  return q;
}

// Both roundings go the same way and the grid of doubles (subnormal or not) is a part of the grid
// of 53-bit numbers, so rounding twice is rounding once.
double rounded_double(mpq_srcptr value, mpfr_rnd_t mode) {
  std::int64_t n = 0, d = 1;
  if (are_short(value, n, d)) return rounded_quotient(n, d, mode);
  MPFR_DECL_INIT(x, kDoubleBits);
  mpfr_set_q(x, value, mode);
  return mpfr_get_d(x, mode);
}

bool is_digit(char c, int base) {
  if (c >= '0' && c <= '9') return true;
  return base == 16 && ((c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'));
}

// Takes the longest prefix of digits off `text`.
std::string take_digits(std::string_view& text, int base) {
  std::size_t n = 0;
  while (n < text.size() && is_digit(text[n], base)) ++n;
  std::string digits(text.substr(0, n));
  text.remove_prefix(n);
  return digits;
}

bool take(std::string_view& text, char lower_case) {
  if (text.empty()) return false;
  const char c = text.front();
  if (c != lower_case && !(c >= 'A' && c <= 'Z' && c - 'A' + 'a' == lower_case)) return false;
  text.remove_prefix(1);
  return true;
}

Integer from_digits(const std::string& digits, int base) {
  Integer result;
  mpz_set_str(result.raw(), digits.c_str(), base);
  return result;
}

// [+-]digits up to the end of `text`, at most Rational::kMaxExponent in absolute value.
std::optional<long> parse_exponent(std::string_view text) {
  const bool negative = take(text, '-');
  if (!negative) take(text, '+');
  const std::string digits = take_digits(text, 10);
  if (digits.empty() || !text.empty()) return std::nullopt;
  long value = 0;
  for (const char c : digits) {
    value = 10 * value + (c - '0');
    if (value > Rational::kMaxExponent) return std::nullopt;
  }
  return negative ? -value : value;
}

// digits[.digits][marker exponent]: mantissa * exponent_base^exponent.
std::optional<Rational> parse_positional(std::string_view text, int base, char marker,
                                         int exponent_base) {
  std::string digits = take_digits(text, base);
  std::string fraction;
  if (take(text, '.')) fraction = take_digits(text, base);
  digits += fraction;
  if (digits.empty()) return std::nullopt;
  long exponent = 0;
  if (take(text, marker)) {
    const std::optional<long> parsed = parse_exponent(text);
    if (!parsed) return std::nullopt;
    exponent = *parsed;
  } else if (!text.empty()) {
    return std::nullopt;
  }
  const long digit_weight = base == 16 ? 4 : 1;
  exponent -= digit_weight * static_cast<long>(fraction.size());
  const Integer scale =
      power(Integer(exponent_base), static_cast<unsigned long>(std::labs(exponent)));
  const Integer mantissa = from_digits(digits, base);
  return exponent >= 0 ? Rational(mantissa * scale) : Rational(mantissa, scale);
}

std::optional<Rational> parse_unsigned(std::string_view text) {
  if (text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
    return parse_positional(text.substr(2), 16, 'p', 2);
  }
  if (text.find('/') == std::string_view::npos) return parse_positional(text, 10, 'e', 10);
  const std::string numerator = take_digits(text, 10);
  if (!take(text, '/')) return std::nullopt;
  const std::string denominator = take_digits(text, 10);
  if (numerator.empty() || denominator.empty() || !text.empty()) return std::nullopt;
  const Integer divisor = from_digits(denominator, 10);
  if (divisor.is_zero()) return std::nullopt;
  return Rational(from_digits(numerator, 10), divisor);
}

}  // namespace

static_assert(GMP_NUMB_BITS == 64);

Rational::Rational(const Integer& value) : Rational() {
  mpz_set(mpq_numref(edit()), value.raw());
  move_in();
}

Rational::Rational(const Integer& numerator, const Integer& denominator) : Rational() {
  require(!denominator.is_zero(), "Rational: the denominator is zero");
  mpz_set(mpq_numref(edit()), numerator.raw());
  mpz_set(mpq_denref(q_), denominator.raw());
  mpq_canonicalize(q_);
  move_in();
}

void Rational::copy_beyond(const Rational& other) {
  mpz_init_set(mpq_numref(q_), mpq_numref(other.q_));
  mpz_init_set(mpq_denref(q_), mpq_denref(other.q_));
}

void Rational::move_out() {
  mpz_t above, below;
  mpz_init_set(above, mpq_numref(q_));
  mpz_init_set(below, mpq_denref(q_));
  *mpq_numref(q_) = *above;
  *mpq_denref(q_) = *below;
}

void Rational::move_in() {
  if (is_within() || !has_words()) return;
  const int size = sign();
  const mp_limb_t n = mpz_getlimbn(mpq_numref(q_), 0), d = mpz_getlimbn(mpq_denref(q_), 0);
  mpq_clear(q_);
  keep_within(size, n, d);
}

bool Rational::sum(const Words& a, const Words& b, Words& out) {
  const std::int64_t common =
      a.denominator == b.denominator ? a.denominator : common_divisor(a.denominator, b.denominator);
  const std::int64_t a_rest = over(a.denominator, common), b_rest = over(b.denominator, common);
  const Int128 above = Int128{a.numerator} * b_rest + Int128{b.numerator} * a_rest;
  if (common == 1) return fits(above, Int128{a_rest} * b_rest, out.numerator, out.denominator);
  // What is left of the common divisor of numerator and denominator divides that of the denominators.
  const std::int64_t left = common_divisor(static_cast<std::int64_t>(above % common), common);
  return fits(left == 1 ? above : above / left, Int128{a_rest} * over(b.denominator, left),
              out.numerator, out.denominator);
}

bool Rational::product(const Words& a, const Words& b, Words& out) {
  // Each is in lowest terms, so equal denominators have nothing in common with either numerator.
  const bool are_equal = a.denominator == b.denominator;
  const std::int64_t down = are_equal ? 1 : common_divisor(a.numerator, b.denominator);
  const std::int64_t up = are_equal ? 1 : common_divisor(b.numerator, a.denominator);
  return fits(Int128{over(a.numerator, down)} * over(b.numerator, up),
              Int128{over(a.denominator, up)} * over(b.denominator, down), out.numerator,
              out.denominator);
}

Rational& Rational::operator+=(const Rational& b) {
  Words u, v, w;
  if (read(u) && b.read(v) && sum(u, v, w)) {
    keep(w);
  } else {
    mpq_add(edit(), q_, b.q_);
  }
  return *this;
}

Rational& Rational::operator-=(const Rational& b) {
  Words u, v, w;
  if (read(u) && b.read(v) && sum(u, {-v.numerator, v.denominator}, w)) {
    keep(w);
  } else {
    mpq_sub(edit(), q_, b.q_);
  }
  return *this;
}

Rational& Rational::operator*=(const Rational& b) {
  Words u, v, w;
  if (read(u) && b.read(v) && product(u, v, w)) {
    keep(w);
  } else {
    mpq_mul(edit(), q_, b.q_);
  }
  return *this;
}

Rational& Rational::operator/=(const Rational& b) {
  Words u, v, w;
  if (read(u) && b.read(v) && v.numerator != 0) {
    const Words inverse =
        v.numerator < 0 ? Words{-v.denominator, -v.numerator} : Words{v.denominator, v.numerator};
    if (product(u, inverse, w)) {
      keep(w);
      return *this;
    }
  }
  mpq_div(edit(), q_, b.q_);
  return *this;
}

std::optional<Rational> Rational::from_double(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  Rational result;
  mpq_set_d(result.edit(), value);
  result.move_in();
  return result;
}

std::optional<Rational> Rational::parse(std::string_view text) {
  if (const auto words = parse_short(text)) {
    std::optional<Rational> result(std::in_place);
    assign(*result, *words);
    return result;
  }
  const bool negative = take(text, '-');
  if (!negative) take(text, '+');
  std::optional<Rational> result = parse_unsigned(text);
  if (result && negative) *result = -std::move(*result);
  return result;
}

Integer Rational::numerator() const {
  Integer result;
  mpz_set(result.raw(), mpq_numref(q_));
  return result;
}

Integer Rational::denominator() const {
  Integer result;
  mpz_set(result.raw(), mpq_denref(q_));
  return result;
}

bool Rational::is_dyadic() const {
  return mpz_scan1(mpq_denref(q_), 0) + 1 == mpz_sizeinbase(mpq_denref(q_), 2);
}

double Rational::lower_double() const { return rounded_double(q_, MPFR_RNDD); }

double Rational::upper_double() const { return rounded_double(q_, MPFR_RNDU); }

double Rational::to_double() const { return rounded_double(q_, MPFR_RNDN); }

std::string Rational::to_string() const {
  const std::string numerator_text = numerator().to_string();
  return is_integer() ? numerator_text : numerator_text + "/" + denominator().to_string();
}

std::string decimal(const Rational& value, int digits) {
  require(digits >= 0, "decimal: negative number of digits");
  Integer scaled = abs(value.numerator()) * power(Integer(10), static_cast<unsigned long>(digits));
  scaled = floor_divide(scaled, value.denominator());
  std::string text = scaled.to_string();
  const auto places = static_cast<std::size_t>(digits);
  if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
  if (places > 0) text.insert(text.size() - places, 1, '.');
  return value.sign() < 0 ? "-" + text : text;
}

}  // namespace kinex
