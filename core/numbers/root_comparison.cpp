// SPDX-License-Identifier: GPL-3.0-or-later
// Comparisons of real roots, and signs of polynomials at them.
#include <algorithm>
#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/dyadic.h"
#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/real_root.h"

namespace kinex {

namespace {

void count_bits(const Polynomial& p, RootCounters& counters) {
  counters.max_bits = std::max<std::uint64_t>(counters.max_bits, p.max_bits());
}

}  // namespace

int RealRoot::side_of(const RealRoot& other) const {
  if (compare_dyadic(upper_, exponent_, other.lower_, other.exponent_) <= 0) return -1;
  return compare_dyadic(lower_, exponent_, other.upper_, other.exponent_) >= 0 ? 1 : 0;
}

bool RealRoot::changes_sign(const Polynomial& g) const {
  const Sign at_lower = sign_at_dyadic(g, lower_, exponent_);
  return at_lower != Sign::kZero && sign_at_dyadic(g, upper_, exponent_) == -at_lower;
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
  for (bool gcd_done = false;;) {
    if (a.rational_) {
      return b.rational_ ? to_int(to_sign(mpq_cmp(a.value_->raw(), b.value_->raw())))
                         : -compare(b, *a.value_, counters);
    }
    if (b.rational_) return compare(a, *b.value_, counters);
    int side = a.side_of(b);
    if (side != 0) return side;
    // Cut both down to the overlap of their intervals.
    a.cut_at(b.lower_, b.exponent_, counters);
    a.cut_at(b.upper_, b.exponent_, counters);
    if (a.rational_) continue;
    side = a.side_of(b);
    if (side != 0) return side;
    b.cut_at(a.lower_, a.exponent_, counters);
    b.cut_at(a.upper_, a.exponent_, counters);
    if (b.rational_) continue;
    side = a.side_of(b);
    if (side != 0) return side;
    if (!gcd_done) {
      gcd_done = true;
      if (a.polynomial_ == b.polynomial_ || *a.polynomial_ == *b.polynomial_) return 0;
      count_bits(*a.polynomial_, counters);
      count_bits(*b.polynomial_, counters);
      // Both intervals are the same now. The gcd g is not zero at its ends, and a root of g inside
      // is a root of both polynomials, so it is a and b; its multiplicity in g is the smaller of
      // two odd ones. So a = b if and only if g changes sign.
      const Polynomial g = gcd(*a.polynomial_, *b.polynomial_, counters.deadline);
      if (g.degree() > 0) {
        ++counters.gcds;
        if (a.changes_sign(g)) return 0;
      }
    }
    a.refine(counters);
    b.refine(counters);
  }
}

Sign sign_at(const Polynomial& q, RealRoot& root, RootCounters& counters) {
  if (q.degree() <= 0) return q.sign_at_plus_infinity();
  for (bool gcd_done = false;;) {
    if (root.rational_) return q.sign_at(*root.value_);
    const std::optional<Sign> sign = sign_on_interval(q, root.lower_, root.upper_, root.exponent_);
    if (sign) return *sign;
    if (!gcd_done) {
      gcd_done = true;
      count_bits(q, counters);
      const Polynomial g = gcd(q, *root.polynomial_, counters.deadline);
      if (g.degree() > 0) {
        ++counters.gcds;
        // Its only possible root in the interval is `root`; the ends are not roots.
        if (root.changes_sign(square_free_part(g, counters.deadline))) return Sign::kZero;
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
    look(counters.deadline);
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
