// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/sturm_instant.h"

#include <algorithm>
#include <utility>

#include "core/numbers/check.h"

namespace kinex {
namespace {

// Bisections of both intervals before equality is tested by a gcd.
constexpr int kBisectionsBeforeGcd = 24;

Rational power_of_two(long k) {
  const Integer p = Integer::power_of_two(static_cast<unsigned long>(k < 0 ? -k : k));
  return k < 0 ? Rational(Integer(1), p) : Rational(p);
}

// Sign of p on (t, t + eps).
Sign sign_after_rational(const RationalPolynomial& p, const Rational& t) {
  Sign s = p.sign_at(t);
  for (RationalPolynomial d = p; s == Sign::kZero && d.degree() > 0; s = d.sign_at(t)) {
    d = d.derivative();
  }
  return s;
}

// -1, 0, +1 if the intervals decide, nullopt if they overlap.
std::optional<int> compare_intervals(const SturmInstant& a, const SturmInstant& b) {
  if (a.is_rational() && b.is_rational()) {
    return a.lower() < b.lower() ? -1 : a.lower() > b.lower() ? 1 : 0;
  }
  // The ends of an isolating interval are not roots.
  if (a.upper() <= b.lower()) return -1;
  if (b.upper() <= a.lower()) return 1;
  return std::nullopt;
}

// One root of p lies in (a, b], and p is not zero at b: bisects until p is not zero at a either.
SturmInstant isolated(const RationalSturm& sturm, Rational a, Rational b, SturmWork& work) {
  const RationalPolynomial& p = sturm.square_free();
  const Sign at_b = p.sign_at(b);
  while (p.sign_at(a) == Sign::kZero) {
    look(work.deadline);
    ++work.refinements;
    const Rational m = dyadic_near_middle(a, b);
    const Sign s = p.sign_at(m);
    if (s == Sign::kZero) return SturmInstant(m);
    (s == at_b ? b : a) = m;
  }
  return SturmInstant(p, std::move(a), std::move(b));
}

}  // namespace

Rational dyadic_near_middle(const Rational& a, const Rational& b) {
  Rational middle = (a + b) / Rational(2);
  if (middle.is_dyadic()) return middle;
  // 2^-k <= (b - a) / 4: width >= 2^(bits(numerator) - 1 - bits(denominator)).
  const Rational width = b - a;
  const long k = 3 + static_cast<long>(width.denominator().bit_length()) -
                 static_cast<long>(width.numerator().bit_length());
  const Rational scaled = middle * power_of_two(k);
  return Rational(floor_divide(scaled.numerator(), scaled.denominator())) * power_of_two(-k);
}

SturmInstant::SturmInstant(const Rational& value) { become(value); }

SturmInstant::SturmInstant(RationalPolynomial polynomial, Rational lower, Rational upper)
    : polynomial_(std::move(polynomial)), lower_(std::move(lower)), upper_(std::move(upper)) {
  if (polynomial_.degree() == 1) {
    become(-polynomial_[0] / polynomial_[1]);
    return;
  }
  sign_at_lower_ = polynomial_.sign_at(lower_);
  require(lower_ < upper_ && sign_at_lower_ != Sign::kZero &&
              polynomial_.sign_at(upper_) == -sign_at_lower_,
          "an isolating interval needs opposite signs at its ends");
}

void SturmInstant::become(const Rational& value) {
  rational_ = true;
  sign_at_lower_ = Sign::kZero;
  lower_ = upper_ = value;
  polynomial_ = RationalPolynomial({-value, Rational(1)});
}

void SturmInstant::refine(SturmWork& work) {
  if (rational_) return;
  look(work.deadline);
  ++work.refinements;
  ++bisections_;
  const Rational m = dyadic_near_middle(lower_, upper_);
  const Sign s = polynomial_.sign_at(m);
  if (s == Sign::kZero) {
    become(m);
  } else {
    (s == sign_at_lower_ ? lower_ : upper_) = m;
  }
}

int SturmInstant::compare(const Rational& t) {
  if (rational_) return lower_ < t ? -1 : lower_ > t ? 1 : 0;
  if (t <= lower_) return 1;
  if (t >= upper_) return -1;
  const Sign s = polynomial_.sign_at(t);
  if (s == Sign::kZero) {
    become(t);
    return 0;
  }
  (s == sign_at_lower_ ? lower_ : upper_) = t;
  return s == sign_at_lower_ ? 1 : -1;
}

int compare(SturmInstant& a, SturmInstant& b, SturmWork& work) {
  for (bool told_apart = false;;) {
    if (const auto order = compare_intervals(a, b)) return *order;
    if (a.is_rational()) return -b.compare(a.lower());
    if (b.is_rational()) return a.compare(b.lower());
    if (!told_apart && std::min(a.bisections(), b.bisections()) >= kBisectionsBeforeGcd) {
      told_apart = true;
      const RationalPolynomial common = gcd(a.polynomial(), b.polynomial(), work);
      const Rational from = std::max(a.lower(), b.lower());
      const Rational to = std::min(a.upper(), b.upper());
      if (common.degree() > 0 && RationalSturm(common, work).count(from, to) > 0) return 0;
    }
    // The wider one.
    if (a.upper() - a.lower() < b.upper() - b.lower()) {
      b.refine(work);
    } else {
      a.refine(work);
    }
  }
}

bool vanishes_at(const RationalPolynomial& p, const SturmInstant& x, SturmWork& work) {
  if (x.is_rational()) return p.sign_at(x.lower()) == Sign::kZero;
  const RationalPolynomial common = gcd(x.polynomial(), p, work);
  return common.degree() > 0 && RationalSturm(common, work).count(x.lower(), x.upper()) > 0;
}

Sign sign_after(const RationalPolynomial& p, const RationalSturm& sturm, SturmInstant& x,
                SturmWork& work) {
  if (!x.is_rational()) {
    int roots = sturm.count(x.lower(), x.upper());
    const int own = roots > 0 && vanishes_at(p, x, work) ? 1 : 0;
    while (roots > own) {
      x.refine(work);
      if (x.is_rational()) return sign_after_rational(p, x.lower());
      roots = sturm.count(x.lower(), x.upper());
    }
    // Besides x itself p has no root in the interval, nor at its right end.
    return p.sign_at(x.upper());
  }
  return sign_after_rational(p, x.lower());
}

std::optional<SturmInstant> first_failure_after(const RationalPolynomial& p,
                                                const RationalSturm& sturm, const Rational& from,
                                                const std::optional<Rational>& until,
                                                SturmWork& work) {
  if (p.degree() == 1) {
    const Rational root = -p[0] / p[1];
    if (p[1].sign() > 0 || (until && root > *until)) return std::nullopt;
    return SturmInstant(root);
  }
  Rational a = from;
  int at_a = sturm.variations(a);
  const int at_end = until ? sturm.variations(*until) : sturm.variations_at_plus_infinity();
  Rational step(1);
  while (at_a > at_end && !(until && a >= *until)) {
    // The nearest root: in (a, b], alone.
    Rational b = a + step;
    if (until && b > *until) b = *until;
    int at_b = sturm.variations(b);
    if (at_b == at_a) {
      a = std::move(b);
      step += step;
      continue;
    }
    while (at_a - at_b > 1) {
      ++work.refinements;
      Rational m = dyadic_near_middle(a, b);
      const int at_m = sturm.variations(m);
      if (at_m == at_a) {
        a = std::move(m);
      } else {
        b = std::move(m);
        at_b = at_m;
      }
    }
    // p is positive between a and this root: its sign after the root decides.
    if (p.sign_at(b) == Sign::kZero) {
      if (sign_after_rational(p, b) == Sign::kNegative) return SturmInstant(b);
    } else if (p.sign_at(b) == Sign::kNegative) {
      return isolated(sturm, std::move(a), std::move(b), work);
    }
    step = b - a;
    a = std::move(b);
    at_a = at_b;
  }
  return std::nullopt;
}

}  // namespace kinex
