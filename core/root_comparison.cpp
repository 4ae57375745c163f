// SPDX-License-Identifier: GPL-3.0-or-later
// Comparisons of real roots, and signs of polynomials at them.
#include <algorithm>
#include <utility>

#include "core/check.h"
#include "core/dyadic.h"
#include "core/polynomial_gcd.h"
#include "core/real_root.h"

namespace kinex {

namespace {

constexpr int kStepsBeforeGcd = 2;

// Sign of q on all of [lower, upper] / 2^exponent by interval Horner; nullopt if it is not certain.
std::optional<Sign> sign_on_interval(const Polynomial& q, Integer lower, Integer upper,
                                     long exponent) {
  if (exponent < 0) {
    lower <<= static_cast<unsigned long>(-exponent);
    upper <<= static_cast<unsigned long>(-exponent);
    exponent = 0;
  }
  const auto scale = static_cast<unsigned long>(exponent);
  Integer low = q.leading();
  Integer high = low;
  Integer term;
  unsigned long shift = 0;
  for (std::size_t i = static_cast<std::size_t>(q.degree()); i-- > 0;) {
    if (lower.sign() >= 0) {
      low *= low.sign() >= 0 ? lower : upper;
      high *= high.sign() >= 0 ? upper : lower;
    } else if (upper.sign() <= 0) {
      Integer next_low = high * (high.sign() >= 0 ? lower : upper);
      high = low * (low.sign() >= 0 ? upper : lower);
      low = std::move(next_low);
    } else {
      Integer next_low = std::min(low * upper, high * lower);
      high = std::max(low * lower, high * upper);
      low = std::move(next_low);
    }
    shift += scale;
    if (q[i].is_zero()) continue;
    mpz_mul_2exp(term.raw(), q[i].raw(), shift);
    low += term;
    high += term;
  }
  if (low.sign() > 0) return Sign::kPositive;
  if (high.sign() < 0) return Sign::kNegative;
  return std::nullopt;
}

void count_bits(const Polynomial& p, RootCounters& counters) {
  counters.max_bits = std::max<std::uint64_t>(counters.max_bits, p.max_bits());
}

}  // namespace

int RealRoot::side_of(const RealRoot& other) const {
  if (compare_dyadic(upper_, exponent_, other.lower_, other.exponent_) <= 0) return -1;
  return compare_dyadic(lower_, exponent_, other.upper_, other.exponent_) >= 0 ? 1 : 0;
}

bool RealRoot::changes_sign_on_overlap(const Polynomial& g, const RealRoot& other) const {
  const bool mine_starts =
      compare_dyadic(lower_, exponent_, other.lower_, other.exponent_) >= 0;
  const bool mine_ends = compare_dyadic(upper_, exponent_, other.upper_, other.exponent_) <= 0;
  const Sign at_start = mine_starts ? sign_at_dyadic(g, lower_, exponent_)
                                    : sign_at_dyadic(g, other.lower_, other.exponent_);
  const Sign at_end = mine_ends ? sign_at_dyadic(g, upper_, exponent_)
                                : sign_at_dyadic(g, other.upper_, other.exponent_);
  return at_start == -at_end && at_start != Sign::kZero;
}

int compare(RealRoot& a, const Rational& b, RootCounters& counters) {
  if (a.rational_) return to_int(to_sign(mpq_cmp(a.value_->raw(), b.raw())));
  // The root is strictly between the ends.
  if (a.lower() >= b) return 1;
  if (a.upper() <= b) return -1;
  const Sign s = a.polynomial_->sign_at(b);
  if (s == Sign::kZero) {
    a.become_rational(b);
    return 0;
  }
  ++counters.refinements;
  return s == a.sign_at_lower_ ? 1 : -1;
}

int compare(RealRoot& a, RealRoot& b, RootCounters& counters) {
  // The gcd g of both polynomials is not zero at an end of the overlap of the intervals (such an end is
  // no root of one of them), and a root of g inside is a root of both, so it is a and b; its
  // multiplicity in g is the smaller of two odd ones. So a = b if and only if g changes sign there.
  bool gcd_done = false;
  for (int steps = 0;; ++steps) {
    if (a.rational_) {
      return b.rational_ ? to_int(to_sign(mpq_cmp(a.value_->raw(), b.value_->raw())))
                         : -compare(b, *a.value_, counters);
    }
    if (b.rational_) return compare(a, *b.value_, counters);
    const int side = a.side_of(b);
    if (side != 0) return side;
    if (!gcd_done) {
      const bool same = a.polynomial_ == b.polynomial_ || *a.polynomial_ == *b.polynomial_;
      if (same || steps == kStepsBeforeGcd) {
        gcd_done = true;
        count_bits(a.polynomial(), counters);
        count_bits(b.polynomial(), counters);
      }
      if (same) {
        if (a.changes_sign_on_overlap(*a.polynomial_, b)) return 0;
      } else if (gcd_done && !coprime_modulo_prime(*a.polynomial_, *b.polynomial_)) {
        ++counters.gcds;
        const Polynomial g = gcd(*a.polynomial_, *b.polynomial_);
        if (g.degree() > 0 && a.changes_sign_on_overlap(g, b)) return 0;
      }
    }
    // Narrow the wider one, or both while they are alike.
    const long a_log = static_cast<long>((a.upper_ - a.lower_).bit_length()) - a.exponent_;
    const long b_log = static_cast<long>((b.upper_ - b.lower_).bit_length()) - b.exponent_;
    if (a_log >= b_log) a.refine(counters);
    if (b_log >= a_log) b.refine(counters);
  }
}

Sign sign_at(const Polynomial& q, RealRoot& root, RootCounters& counters) {
  if (q.degree() <= 0) return q.sign_at_plus_infinity();
  for (int steps = 0;; ++steps) {
    if (root.rational_) return q.sign_at(*root.value_);
    const std::optional<Sign> sign =
        sign_on_interval(q, root.lower_, root.upper_, root.exponent_);
    if (sign) return *sign;
    if (steps == kStepsBeforeGcd) {
      count_bits(q, counters);
      if (!coprime_modulo_prime(q, *root.polynomial_)) {
        ++counters.gcds;
        // Its only possible root in the interval is `root`; the ends are no roots.
        const Polynomial g = square_free_part(gcd(q, *root.polynomial_));
        if (g.degree() > 0 && root.changes_sign_on_overlap(g, root)) return Sign::kZero;
      }
    }
    root.refine(counters);
  }
}

namespace {

struct FirstDerivative {
  Sign sign;  // of the first derivative that does not vanish (the 0th is q)
  int order;
};

FirstDerivative first_derivative_at(const Polynomial& q, RealRoot& root, RootCounters& counters) {
  FirstDerivative result{sign_at(q, root, counters), 0};
  Polynomial derivative = q;
  while (result.sign == Sign::kZero && derivative.degree() > 0) {
    derivative = derivative.derivative();
    result = {sign_at(derivative, root, counters), result.order + 1};
  }
  return result;
}

}  // namespace

Sign sign_after(const Polynomial& q, RealRoot& root, RootCounters& counters) {
  return first_derivative_at(q, root, counters).sign;
}

Sign sign_before(const Polynomial& q, RealRoot& root, RootCounters& counters) {
  const FirstDerivative first = first_derivative_at(q, root, counters);
  return first.order % 2 == 0 ? first.sign : -first.sign;
}

std::string decimal(RealRoot& root, int digits, RootCounters& counters) {
  require(digits >= 0, "decimal: negative number of digits");
  const Integer scale = power(Integer(10), static_cast<unsigned long>(digits));
  long bits = static_cast<long>(scale.bit_length()) + 2;
  root.refine_to(bits, counters);
  while (!root.is_rational()) {
    const Rational low = root.lower() * Rational(scale);
    const Rational high = root.upper() * Rational(scale);
    const Integer floor_low = floor_divide(low.numerator(), low.denominator());
    const Integer floor_high = floor_divide(high.numerator(), high.denominator());
    Integer floor_root = floor_low;
    if (floor_low != floor_high) {
      if (floor_high != floor_low + Integer(1)) {
        root.refine_to(++bits, counters);
        continue;
      }
      const int side = compare(root, Rational(floor_high, scale), counters);
      if (side == 0) break;  // now known to be rational
      if (side > 0) floor_root = floor_high;
    }
    // Strictly between two multiples of 1/scale: all numbers there have the same digits.
    return decimal(Rational(floor_root * Integer(2) + Integer(1), scale * Integer(2)), digits);
  }
  return decimal(root.value(), digits);
}

}  // namespace kinex
