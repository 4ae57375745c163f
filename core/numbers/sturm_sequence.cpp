// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/sturm_sequence.h"

#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/polynomial_gcd.h"

namespace kinex {

namespace {

// A positive multiple of -(a mod b), primitive.
Polynomial negated_remainder(const Polynomial& a, const Polynomial& b) {
  std::vector<Integer> rest = a.coefficients();
  const auto size_b = static_cast<std::size_t>(b.degree()) + 1;
  const Integer scale = abs(b.leading());
  const bool negative = b.leading().sign() < 0;
  while (rest.size() >= size_b) {
    Integer lead = std::move(rest.back());
    rest.pop_back();
    if (lead.is_zero()) continue;
    if (negative) lead.negate();
    const std::size_t k = rest.size() + 1 - size_b;
    for (Integer& c : rest) c *= scale;
    for (std::size_t i = 0; i + 1 < size_b; ++i) rest[k + i].subtract_product(lead, b[i]);
  }
  for (Integer& c : rest) c.negate();
  return Polynomial(std::move(rest)).primitive_part();
}

class VariationCounter {
 public:
  void add(Sign s) {
    if (s == Sign::kZero) return;
    if (s == -last_) ++count_;
    last_ = s;
  }
  int count() const { return count_; }

 private:
  Sign last_ = Sign::kZero;
  int count_ = 0;
};

}  // namespace

SturmSequence::SturmSequence(const Polynomial& p) {
  require(!p.is_zero(), "SturmSequence: zero polynomial");
  Polynomial derivative = p.derivative();
  if (p.degree() == 0) {
    sequence_.push_back(p);
    return;
  }
  if (coprime_modulo_prime(p, derivative)) {
    sequence_.push_back(p.primitive_part());
    sequence_.push_back(derivative.primitive_part());
  } else {
    const Polynomial common = gcd(p, derivative);
    sequence_.push_back(exact_quotient(p, common));
    sequence_.push_back(exact_quotient(derivative, common));
  }
  while (sequence_.back().degree() > 0) {
    sequence_.push_back(
        negated_remainder(sequence_[sequence_.size() - 2], sequence_[sequence_.size() - 1]));
  }
}

int SturmSequence::variations_at(const Rational& t) const {
  VariationCounter counter;
  for (const Polynomial& p : sequence_) counter.add(p.sign_at(t));
  return counter.count();
}

int SturmSequence::variations_at_plus_infinity() const {
  VariationCounter counter;
  for (const Polynomial& p : sequence_) counter.add(p.sign_at_plus_infinity());
  return counter.count();
}

int SturmSequence::variations_at_minus_infinity() const {
  VariationCounter counter;
  for (const Polynomial& p : sequence_) counter.add(p.sign_at_minus_infinity());
  return counter.count();
}

int SturmSequence::count_between(const Rational& a, const Rational& b) const {
  require(a <= b, "SturmSequence::count_between: the ends are in the wrong order");
  return variations_at(a) - variations_at(b);
}

int SturmSequence::count_above(const Rational& a) const {
  return variations_at(a) - variations_at_plus_infinity();
}

int SturmSequence::count_all() const {
  return variations_at_minus_infinity() - variations_at_plus_infinity();
}

}  // namespace kinex
