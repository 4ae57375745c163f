// SPDX-License-Identifier: GPL-3.0-or-later
// SturmSequence: counts distinct real roots in an interval, exactly.
// Source: Sturm's theorem; the signed primitive remainder sequence over the integers.
#ifndef KINEX_CORE_NUMBERS_STURM_SEQUENCE_H
#define KINEX_CORE_NUMBERS_STURM_SEQUENCE_H

#include <vector>

#include "core/numbers/polynomial.h"

namespace kinex {

class SturmSequence {
 public:
  // p not zero. It need not be square-free: the sequence is divided by gcd(p, p'), so the counts
  // are those of distinct roots, valid everywhere, at multiple roots too.
  explicit SturmSequence(const Polynomial& p);

  // Distinct real roots in the half-open interval (a, b]; requires a <= b.
  int count_between(const Rational& a, const Rational& b) const;
  // Distinct real roots in (a, +infinity), and on the whole line.
  int count_above(const Rational& a) const;
  int count_all() const;

  int variations_at(const Rational& t) const;
  int variations_at_plus_infinity() const;
  int variations_at_minus_infinity() const;
  const std::vector<Polynomial>& sequence() const { return sequence_; }

 private:
  std::vector<Polynomial> sequence_;
};

}  // namespace kinex

#endif
