// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/short_rational.h"

#include <array>
#include <cstddef>
#include <limits>
#include <numeric>

namespace kinex {

namespace {

constexpr std::size_t kMaxDigits = 18;  // 10^18 < 2^63
// 10^0 .. 10^18.
constexpr std::array<std::int64_t, kMaxDigits + 1> kPowers = [] {
  std::array<std::int64_t, kMaxDigits + 1> powers{};
  powers[0] = 1;
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = 10 * powers[k - 1];
  return powers;
}();

// Takes the longest prefix of digits, of which there are `count` then; at most kMaxDigits + 1 of them.
std::int64_t take_digits(std::string_view& text, std::size_t& count, std::int64_t value = 0) {
  std::size_t n = 0;
  while (n < text.size() && count + n <= kMaxDigits && text[n] >= '0' && text[n] <= '9') {
    if (count + n < kMaxDigits) value = 10 * value + (text[n] - '0');
    ++n;
  }
  count += n;
  text.remove_prefix(n);
  return value;
}

// Requires denominator > 0.
ShortRational reduced(std::int64_t numerator, std::int64_t denominator) {
  if (denominator == 1) return {numerator, 1};
  // One division first: numerators are mostly longer than denominators.
  const std::int64_t common = std::gcd(denominator, numerator % denominator);
  return {numerator / common, denominator / common};
}

// The product of both, unless it needs more than 128 bits.
bool multiply(Int128 a, Int128 b, Int128& product) { return !__builtin_mul_overflow(a, b, &product); }

// a - b as above / below.
bool subtract(const ShortRational& a, const ShortRational& b, Int128& above, Int128& below) {
  below = Int128{a.denominator} * b.denominator;
  return !__builtin_sub_overflow(Int128{a.numerator} * b.denominator, Int128{b.numerator} * a.denominator,
                                 &above);
}

bool short_part(mpz_srcptr part, std::int64_t& value) {
  if (mpz_size(part) > 1) return false;
  const mp_limb_t limb = mpz_getlimbn(part, 0);
  if (limb > static_cast<mp_limb_t>(std::numeric_limits<std::int64_t>::max())) return false;
  value = mpz_sgn(part) < 0 ? -static_cast<std::int64_t>(limb) : static_cast<std::int64_t>(limb);
  return true;
}

}  // namespace

std::optional<ShortRational> parse_short(std::string_view text) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  std::size_t above = 0;
  std::int64_t numerator = take_digits(text, above);
  std::int64_t denominator = 1;
  if (above == 0 || above > kMaxDigits) return std::nullopt;
  if (!text.empty()) {
    const char mark = text.front();
    text.remove_prefix(1);
    if (mark == '/') {
      std::size_t below = 0;
      denominator = take_digits(text, below);
      if (below > kMaxDigits || denominator == 0) return std::nullopt;
    } else if (mark == '.') {
      const std::size_t before = above;
      numerator = take_digits(text, above, numerator);
      if (above > kMaxDigits) return std::nullopt;
      denominator = kPowers[above - before];
    }
    if (!text.empty() || (mark != '/' && mark != '.')) return std::nullopt;
  }
  return reduced(negative ? -numerator : numerator, denominator);
}

std::optional<ShortRational> shortened(const Rational& value) {
  ShortRational result;
  if (!short_part(mpq_numref(value.raw()), result.numerator)) return std::nullopt;
  if (!short_part(mpq_denref(value.raw()), result.denominator)) return std::nullopt;
  return result;
}

void assign(Rational& target, const ShortRational& value) {
  target.set_words(value.numerator, value.denominator);
}

std::optional<bool> equal_lines(const ShortRational& a0, const ShortRational& a1, const ShortRational& b0,
                                const ShortRational& b1, const ShortRational& t) {
  // (a0 - b0) = (b1 - a1) t, without fractions.
  Int128 rise, rise_below, slope, slope_below, left, right;
  if (!subtract(a0, b0, rise, rise_below) || !subtract(b1, a1, slope, slope_below)) return std::nullopt;
  if (rise == 0 && slope == 0) return true;
  if (!multiply(rise, slope_below, left) || !multiply(left, t.denominator, left)) return std::nullopt;
  if (!multiply(slope, rise_below, right) || !multiply(right, t.numerator, right)) return std::nullopt;
  return left == right;
}

}  // namespace kinex
