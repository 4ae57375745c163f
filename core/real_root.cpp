// SPDX-License-Identifier: GPL-3.0-or-later
// Representation and refinement of real roots. See root_isolation.cpp for where they come from and
// root_comparison.cpp for what is asked of them.
#include "core/real_root.h"

#include <mpfr.h>

#include <algorithm>
#include <utility>

#include "core/check.h"
#include "core/dyadic.h"

namespace kinex {

namespace {

constexpr unsigned kMaxQirBits = 1u << 20;

double rounded(const Integer& numerator, long exponent, mpfr_rnd_t mode) {
  MPFR_DECL_INIT(x, 53);
  mpfr_set_z_2exp(x, numerator.raw(), -exponent, mode);
  return mpfr_get_d(x, mode);
}

}  // namespace

RealRoot::RealRoot(const Rational& value) { become_rational(value); }

RealRoot::RealRoot(Polynomial polynomial, const Rational& lower, const Rational& upper)
    : polynomial_(std::make_shared<const Polynomial>(std::move(polynomial))) {
  require(lower.is_dyadic() && upper.is_dyadic(), "RealRoot: the ends must be dyadic");
  require(lower < upper, "RealRoot: the ends are in the wrong order");
  exponent_ = std::max(dyadic_exponent(lower), dyadic_exponent(upper));
  lower_ = lower.numerator() << static_cast<unsigned long>(exponent_ - dyadic_exponent(lower));
  upper_ = upper.numerator() << static_cast<unsigned long>(exponent_ - dyadic_exponent(upper));
  sign_at_lower_ = evaluate(lower_, value_at_lower_);
  require(sign_at_lower_ != Sign::kZero && evaluate(upper_, value_at_upper_) == -sign_at_lower_,
          "RealRoot: the polynomial must have opposite signs at the ends");
}

RealRoot::RealRoot(std::shared_ptr<const Polynomial> polynomial, Integer lower, Integer upper,
                   long exponent, Sign sign_at_lower)
    : polynomial_(std::move(polynomial)),
      lower_(std::move(lower)),
      upper_(std::move(upper)),
      exponent_(exponent),
      sign_at_lower_(sign_at_lower) {
  const std::size_t common = std::min(lower_.is_zero() ? upper_.trailing_zeros() : lower_.trailing_zeros(),
                                      upper_.is_zero() ? lower_.trailing_zeros() : upper_.trailing_zeros());
  if (common > 0) {
    lower_ >>= common;
    upper_ >>= common;
    exponent_ -= static_cast<long>(common);
  }
}

void RealRoot::become_rational(const Rational& value) {
  const Rational copy = value;  // it may be a part of this
  polynomial_ = std::make_shared<const Polynomial>(
      std::vector<Integer>{-copy.numerator(), copy.denominator()});
  lower_ = Integer();
  upper_ = Integer();
  value_at_lower_ = Value();
  value_at_upper_ = Value();
  exponent_ = 0;
  sign_at_lower_ = Sign::kZero;
  rational_ = true;
  value_ = copy;
}

Rational RealRoot::lower() const { return rational_ ? *value_ : dyadic(lower_, exponent_); }

Rational RealRoot::upper() const { return rational_ ? *value_ : dyadic(upper_, exponent_); }

Rational RealRoot::value() const {
  require(rational_, "RealRoot::value: the root is not known to be rational");
  return *value_;
}

double RealRoot::lower_double() const {
  return rational_ ? value_->lower_double() : rounded(lower_, exponent_, MPFR_RNDD);
}

double RealRoot::upper_double() const {
  return rational_ ? value_->upper_double() : rounded(upper_, exponent_, MPFR_RNDU);
}

bool RealRoot::width_at_most(long bits) const {
  if (rational_) return true;
  const long room = exponent_ - bits;  // upper_ - lower_ <= 2^room
  if (room < 0) return false;
  const Integer width = upper_ - lower_;
  const long log_width = static_cast<long>(width.bit_length()) - 1;
  return log_width < room ||
         (log_width == room && static_cast<long>(width.trailing_zeros()) == log_width);
}

// The sign at numerator / 2^exponent_, and enough of the value to interpolate the next guess.
Sign RealRoot::evaluate(const Integer& numerator, Value& value) const {
  const unsigned long trailing = numerator.trailing_zeros();
  long exponent = exponent_;
  Integer reduced = numerator;
  if (exponent < 0) {
    reduced <<= static_cast<unsigned long>(-exponent);
    exponent = 0;
  } else if (trailing > 0) {
    const unsigned long common = std::min(trailing, static_cast<unsigned long>(exponent));
    reduced >>= common;
    exponent -= static_cast<long>(common);
  }
  if (reduced.is_zero()) exponent = 0;
  Integer result =
      polynomial_->scaled_value_at_dyadic(reduced, static_cast<unsigned long>(exponent));
  const Sign sign = to_sign(result.sign());
  value.exponent = -exponent * polynomial_->degree();
  // The next guess is for at most 2^(2 qir_bits) parts.
  const std::size_t wanted = 4 * static_cast<std::size_t>(qir_bits_) + 64;
  const std::size_t bits = result.bit_length();
  if (bits > 2 * wanted) {
    mpz_tdiv_q_2exp(result.raw(), result.raw(), bits - wanted);
    value.exponent += static_cast<long>(bits - wanted);
  }
  value.mantissa = std::move(result);
  return sign;
}

// Where the line through both ends vanishes, relative to lower_; half-way if a value is not known.
Integer RealRoot::guess(const Integer& width) {
  if (qir_bits_ < 2) return width >> 1;
  if (value_at_lower_.mantissa.is_zero()) evaluate(lower_, value_at_lower_);
  if (value_at_upper_.mantissa.is_zero()) evaluate(upper_, value_at_upper_);
  Integer low = abs(value_at_lower_.mantissa);
  Integer high = abs(value_at_upper_.mantissa);
  const long shift = value_at_lower_.exponent - value_at_upper_.exponent;
  // Beyond this many bits one end is the guess anyway.
  const long difference =
      shift + static_cast<long>(low.bit_length()) - static_cast<long>(high.bit_length());
  const long bits = static_cast<long>(width.bit_length());
  if (difference > bits + 4) return width;
  if (difference < -bits - 4) return Integer();
  if (shift >= 0) {
    low <<= static_cast<unsigned long>(shift);
  } else {
    high <<= static_cast<unsigned long>(-shift);
  }
  high += low;
  low *= width;
  mpz_tdiv_q(low.raw(), low.raw(), high.raw());
  return low;
}

void RealRoot::step(unsigned max_bits, RootCounters& counters) {
  ++counters.refinements;
  const unsigned bits = std::max(1u, std::min(qir_bits_, max_bits));
  Integer width = upper_ - lower_;
  // Points of the grid are the multiples of 2^spacing; between width/2^(bits+1) and width/2^bits.
  long spacing = static_cast<long>(width.bit_length()) - 1 - static_cast<long>(bits);
  // Room for the guess to fall between the points, so that rounding to the nearest makes sense.
  const long fine = spacing - 1;
  if (fine < 0) {
    const auto shift = static_cast<unsigned long>(-fine);
    lower_ <<= shift;
    upper_ <<= shift;
    width <<= shift;
    exponent_ -= fine;
    spacing -= fine;
  }
  const auto grid = static_cast<unsigned long>(spacing);
  const Integer pitch = Integer::power_of_two(grid);
  // The point of the grid nearest to the guess, strictly inside.
  Integer x = lower_ + guess(width) + (pitch >> 1);
  x >>= grid;
  x <<= grid;
  while (x <= lower_) x += pitch;
  while (x >= upper_) x -= pitch;

  Value value;
  const Sign sign = evaluate(x, value);
  if (sign == Sign::kZero) {
    become_rational(dyadic(x, exponent_));
    return;
  }
  const bool root_above = sign == sign_at_lower_;
  Integer neighbour = root_above ? x + pitch : x - pitch;
  if (root_above) {
    lower_ = std::move(x);
    value_at_lower_ = std::move(value);
  } else {
    upper_ = std::move(x);
    value_at_upper_ = std::move(value);
  }
  bool success = true;
  if (bits > 1 && (root_above ? neighbour < upper_ : neighbour > lower_)) {
    Value neighbour_value;
    const Sign neighbour_sign = evaluate(neighbour, neighbour_value);
    if (neighbour_sign == Sign::kZero) {
      become_rational(dyadic(neighbour, exponent_));
      return;
    }
    if (neighbour_sign == sign_at_lower_) {
      lower_ = std::move(neighbour);
      value_at_lower_ = std::move(neighbour_value);
      success = !root_above;
    } else {
      upper_ = std::move(neighbour);
      value_at_upper_ = std::move(neighbour_value);
      success = root_above;
    }
  }
  if (!success) {
    qir_bits_ = std::max(1u, qir_bits_ / 2);
  } else if (bits == qir_bits_) {
    qir_bits_ = std::min(2 * qir_bits_, kMaxQirBits);
  }
  // Keep the numbers short.
  const unsigned long common = std::min(lower_.is_zero() ? upper_.trailing_zeros() : lower_.trailing_zeros(),
                                        upper_.is_zero() ? lower_.trailing_zeros() : upper_.trailing_zeros());
  if (common > 0) {
    lower_ >>= common;
    upper_ >>= common;
    exponent_ -= static_cast<long>(common);
  }
}

void RealRoot::refine(RootCounters& counters) {
  if (rational_) return;
  // Until the width is at most half of what it was.
  const Integer width = upper_ - lower_;
  const long exponent = exponent_;
  do {
    step(kMaxQirBits, counters);
  } while (!rational_ && compare_dyadic((upper_ - lower_) << 1, exponent_, width, exponent) > 0);
}

void RealRoot::refine_to(long bits, RootCounters& counters) {
  while (!width_at_most(bits)) {
    const long log_width = static_cast<long>((upper_ - lower_).bit_length()) - exponent_;
    const long missing = std::min<long>(log_width + bits + 1, kMaxQirBits);
    step(static_cast<unsigned>(std::max(missing, 1L)), counters);
  }
}

}  // namespace kinex
