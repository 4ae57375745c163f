// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/rational_sturm.h"

#include <algorithm>
#include <utility>

#include "core/numbers/check.h"

namespace kinex {
namespace {

std::uint64_t bits(const Rational& q) {
  if (q.is_zero()) return 0;
  return std::max(mpz_sizeinbase(mpq_numref(q.raw()), 2), mpz_sizeinbase(mpq_denref(q.raw()), 2));
}

void note_bits(const RationalPolynomial& p, SturmWork& work) {
  work.max_bits = std::max(work.max_bits, p.max_bits());
}

// Counts sign changes, zeros left out.
class VariationCounter {
 public:
  void add(Sign s) {
    if (s == Sign::kZero) return;
    if (last_ != Sign::kZero && s != last_) ++count_;
    last_ = s;
  }
  int count() const { return count_; }

 private:
  Sign last_ = Sign::kZero;
  int count_ = 0;
};

}  // namespace

RationalPolynomial::RationalPolynomial(std::vector<Rational> coefficients)
    : c_(std::move(coefficients)) {
  while (!c_.empty() && c_.back().is_zero()) c_.pop_back();
}

Rational RationalPolynomial::value_at(const Rational& t) const {
  Rational value;
  for (std::size_t i = c_.size(); i-- > 0;) {
    value *= t;
    value += c_[i];
  }
  return value;
}

RationalPolynomial RationalPolynomial::derivative() const {
  std::vector<Rational> d;
  for (std::size_t i = 1; i < c_.size(); ++i) d.push_back(c_[i] * Rational(static_cast<int>(i)));
  return RationalPolynomial(std::move(d));
}

void RationalPolynomial::normalise() {
  if (is_zero()) return;
  Integer denominator(1), common;
  for (const Rational& c : c_) {
    denominator = lcm(denominator, c.denominator());
    common = kinex::gcd(common, c.numerator());
  }
  const Rational factor(denominator, common);
  for (Rational& c : c_) c *= factor;
}

std::uint64_t RationalPolynomial::max_bits() const {
  std::uint64_t most = 0;
  for (const Rational& c : c_) most = std::max(most, bits(c));
  return most;
}

RationalPolynomial operator-(RationalPolynomial a) {
  for (Rational& c : a.c_) c = -c;
  return a;
}

Division divide(const RationalPolynomial& a, const RationalPolynomial& b) {
  require(!b.is_zero(), "division by the zero polynomial");
  if (a.degree() < b.degree()) return {RationalPolynomial(), a};
  std::vector<Rational> rest = a.coefficients();
  const std::size_t n = b.coefficients().size();
  std::vector<Rational> quotient(rest.size() - n + 1);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = rest[k + n - 1] / b.leading();
    if (quotient[k].is_zero()) continue;
    for (std::size_t i = 0; i < n; ++i) rest[k + i] -= quotient[k] * b[i];
  }
  return {RationalPolynomial(std::move(quotient)), RationalPolynomial(std::move(rest))};
}

RationalPolynomial gcd(RationalPolynomial a, RationalPolynomial b, SturmWork& work) {
  ++work.gcds;
  while (!b.is_zero()) {
    look(work.deadline);
    RationalPolynomial rest = divide(a, b).remainder;
    rest.normalise();
    note_bits(rest, work);
    a = std::exchange(b, std::move(rest));
  }
  a.normalise();
  return a;
}

RationalSturm::RationalSturm(const RationalPolynomial& p, SturmWork& work)
    : deadline_(work.deadline) {
  require(!p.is_zero(), "the zero polynomial has no Sturm sequence");
  note_bits(p, work);
  sequence_.push_back(p);
  RationalPolynomial next = p.derivative();
  while (!next.is_zero()) {
    look(work.deadline);
    sequence_.push_back(std::move(next));
    const std::size_t k = sequence_.size();
    next = -divide(sequence_[k - 2], sequence_[k - 1]).remainder;
    next.normalise();
    note_bits(next, work);
  }
  if (sequence_.back().degree() == 0) return;
  // A common factor changes all signs or none at a point, so dividing by it changes no count.
  RationalPolynomial common = sequence_.back();
  if (common.leading().sign() < 0) common = -std::move(common);
  for (RationalPolynomial& s : sequence_) {
    look(work.deadline);
    s = divide(s, common).quotient;
    s.normalise();
    note_bits(s, work);
  }
}

int RationalSturm::variations(const Rational& t) const {
  VariationCounter counter;
  for (const RationalPolynomial& s : sequence_) {
    look(deadline_);
    counter.add(s.sign_at(t));
  }
  return counter.count();
}

int RationalSturm::variations_at_minus_infinity() const {
  VariationCounter counter;
  for (const RationalPolynomial& s : sequence_) counter.add(s.sign_at_minus_infinity());
  return counter.count();
}

int RationalSturm::variations_at_plus_infinity() const {
  VariationCounter counter;
  for (const RationalPolynomial& s : sequence_) counter.add(s.sign_at_plus_infinity());
  return counter.count();
}

}  // namespace kinex
