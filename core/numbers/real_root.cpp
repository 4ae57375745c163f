// SPDX-License-Identifier: GPL-3.0-or-later
// Representation and refinement of real roots. Isolation: root_isolation.cpp; comparisons and
// signs: root_comparison.cpp.
#include "core/numbers/real_root.h"

#include <mpfr.h>

#include <algorithm>
#include <utility>

#include "core/numbers/approximate_root.h"
#include "core/numbers/check.h"
#include "core/numbers/dyadic.h"

namespace kinex {

namespace {

constexpr unsigned kMaxQirBits = 1u << 20;
constexpr unsigned kFirstQirBits = 4;  // if doubles do not suffice

double rounded(const Integer& numerator, long exponent, mpfr_rnd_t mode) {
  MPFR_DECL_INIT(x, 53);
  mpfr_set_z_2exp(x, numerator.raw(), -exponent, mode);
  return mpfr_get_d(x, mode);
}

}  // namespace

RealRoot::RealRoot(Rational value) : rational_(true), value_(std::move(value)) {}

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
  shorten();
}

// Removes common factors of two.
void RealRoot::shorten() {
  if (!lower_.is_even() || !upper_.is_even()) return;
  const std::size_t common = lower_.is_zero() ? upper_.trailing_zeros()
                             : upper_.is_zero()
                                 ? lower_.trailing_zeros()
                                 : std::min(lower_.trailing_zeros(), upper_.trailing_zeros());
  lower_ >>= common;
  upper_ >>= common;
  exponent_ -= static_cast<long>(common);
}

// Requires exponent >= exponent_.
void RealRoot::set_exponent(long exponent) {
  if (exponent == exponent_) return;
  const auto shift = static_cast<unsigned long>(exponent - exponent_);
  lower_ <<= shift;
  upper_ <<= shift;
  exponent_ = exponent;
}

void RealRoot::become_rational(const Rational& value) {
  if (!value_ || &*value_ != &value) value_ = value;
  polynomial_ = nullptr;
  lower_ = Integer();
  upper_ = Integer();
  value_at_lower_ = Value();
  value_at_upper_ = Value();
  exponent_ = 0;
  sign_at_lower_ = Sign::kZero;
  rational_ = true;
}

Polynomial RealRoot::polynomial() const {
  if (!rational_) return *polynomial_;
  return Polynomial(std::vector<Integer>{-value_->numerator(), value_->denominator()});
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

// The zero of the line through both ends, relative to lower_; half-way if a value is not known.
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

bool RealRoot::narrow_around(const Integer& guess, unsigned long grid, bool try_neighbour) {
  const Integer pitch = Integer::power_of_two(grid);
  // The multiple nearest to the guess, strictly inside.
  Integer x = guess;
  if (grid > 0) mpz_add(x.raw(), x.raw(), (pitch >> 1).raw());
  x >>= grid;
  x <<= grid;
  while (x <= lower_) x += pitch;
  while (x >= upper_) x -= pitch;
  Value value;
  Sign sign = evaluate(x, value);
  if (sign == Sign::kZero) {
    become_rational(dyadic(x, exponent_));
    return true;
  }
  const bool root_above = sign == sign_at_lower_;
  Integer neighbour = root_above ? x + pitch : x - pitch;
  (root_above ? lower_ : upper_) = std::move(x);
  (root_above ? value_at_lower_ : value_at_upper_) = std::move(value);
  if (root_above ? neighbour >= upper_ : neighbour <= lower_) return true;
  if (!try_neighbour) return false;
  sign = evaluate(neighbour, value);
  if (sign == Sign::kZero) {
    become_rational(dyadic(neighbour, exponent_));
    return true;
  }
  const bool below_root = sign == sign_at_lower_;
  (below_root ? lower_ : upper_) = std::move(neighbour);
  (below_root ? value_at_lower_ : value_at_upper_) = std::move(value);
  return below_root != root_above;
}

void RealRoot::cut_at(const Integer& numerator, long exponent, RootCounters& counters) {
  if (rational_ || compare_dyadic(numerator, exponent, lower_, exponent_) <= 0 ||
      compare_dyadic(numerator, exponent, upper_, exponent_) >= 0) {
    return;
  }
  ++counters.refinements;
  set_exponent(std::max(exponent, exponent_));
  Integer x = scaled_by_power(numerator, exponent_ - exponent);
  Value value;
  const Sign sign = evaluate(x, value);
  if (sign == Sign::kZero) {
    become_rational(dyadic(x, exponent_));
    return;
  }
  const bool root_above = sign == sign_at_lower_;
  (root_above ? lower_ : upper_) = std::move(x);
  (root_above ? value_at_lower_ : value_at_upper_) = std::move(value);
  shorten();
}

bool RealRoot::step_from_double() {
  const std::optional<ApproximateRoot> root =
      approximate_root(*polynomial_, lower_, upper_, exponent_, to_int(sign_at_lower_));
  if (!root) return false;
  const Integer width = upper_ - lower_;
  // log2 of the width of the interval and of the parts wanted.
  const long bits = static_cast<long>(width.bit_length()) - 1 - exponent_ - root->log_error;
  if (bits < 3) return false;
  const long exponent = std::max(exponent_, std::max(-root->log_error, root->center_exponent));
  set_exponent(exponent);
  const Integer center = root->center
                         << static_cast<unsigned long>(exponent - root->center_exponent);
  qir_bits_ = static_cast<unsigned>(bits);
  if (!narrow_around(center, static_cast<unsigned long>(exponent + root->log_error), true)) {
    qir_bits_ = 2;
  }
  if (!rational_) shorten();
  return true;
}

void RealRoot::step(unsigned max_bits, RootCounters& counters) {
  look(counters.deadline);
  ++counters.refinements;
  if (!tried_double_) {
    tried_double_ = true;
    if (step_from_double()) return;
    qir_bits_ = kFirstQirBits;
  }
  const unsigned bits = std::max(1u, std::min(qir_bits_, max_bits));
  Integer width = upper_ - lower_;
  // The grid is between width/2^(bits+1) and width/2^bits, with one spare bit for the guess.
  long grid = static_cast<long>(width.bit_length()) - 1 - static_cast<long>(bits);
  if (grid < 1) {
    const long shift = 1 - grid;
    set_exponent(exponent_ + shift);
    width <<= static_cast<unsigned long>(shift);
    grid = 1;
  }
  const bool success =
      narrow_around(lower_ + guess(width), static_cast<unsigned long>(grid), bits > 1);
  if (rational_) return;
  if (!success && bits > 1) {
    qir_bits_ = std::max(1u, qir_bits_ / 2);
  } else if (bits == qir_bits_) {
    qir_bits_ = std::min(2 * qir_bits_, kMaxQirBits);
  }
  shorten();
}

void RealRoot::refine(RootCounters& counters) {
  if (rational_) return;
  // Until the width is at most half the former one.
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
