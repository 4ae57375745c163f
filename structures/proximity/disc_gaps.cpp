// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/disc_gaps.h"

#include "predicates/points/gap_predicates.h"

namespace kinex {

DiscGaps::Signed::Signed(Kernel& kernel, int dimension, int term)
    : plus(kernel, make_gap_claim(static_cast<GapTerm>(term), false, dimension)),
      minus(kernel, make_gap_claim(static_cast<GapTerm>(term), true, dimension)) {}

DiscGaps::DiscGaps(Kernel& kernel, int dimension)
    : terms_{Signed(kernel, dimension, kRadii), Signed(kernel, dimension, kLeft),
             Signed(kernel, dimension, kRight), Signed(kernel, dimension, kProduct)} {}

// With the pairs exchanged radius_order is negated, gap_left becomes -gap_right and the reverse, and
// gap_product stays.
Query DiscGaps::query(Term term, bool negated, const Value& front, const Value& back) const {
  const bool exchanged = back < front;
  if (exchanged && term != kProduct) negated = !negated;
  if (exchanged && term == kLeft) {
    term = kRight;
  } else if (exchanged && term == kRight) {
    term = kLeft;
  }
  const Value& first = exchanged ? back : front;
  const Value& second = exchanged ? front : back;
  const std::array<ObjectId, 4> ids{first[0], first[1], second[0], second[1]};
  return (negated ? terms_[term].minus : terms_[term].plus).query(ids);
}

CaseChoice DiscGaps::choose(Kernel& kernel, const Value& front, const Value& back) const {
  const auto sign = [&](Term term) { return kernel.sign_after(query(term, false, front, back)); };
  if (sign(kRadii) != Sign::kNegative) {
    const Sign left = sign(kLeft);
    if (left == Sign::kPositive) return {kFirst, true, false};
    const Sign product = sign(kProduct);
    if (left == Sign::kZero) return {kFirst, true, product == Sign::kZero};
    // If the gaps are equal now, the product is zero, while the left claim may be negative already: what
    // fails has to be the former.
    if (product == Sign::kPositive) return {kSecond, false, false};
    return {kSecond, true, product == Sign::kZero};
  }
  if (sign(kRight) == Sign::kNegative) return {kThird, false, false};
  const Sign product = sign(kProduct);
  return {kThird, product != Sign::kNegative, product == Sign::kZero};
}

Conjunction DiscGaps::claims_of(std::uint8_t which, const Value& front, const Value& back) const {
  switch (which) {
    case kFirst:
      return {query(kRadii, false, front, back), query(kLeft, false, front, back), {}};
    case kSecond:
      return {query(kRadii, false, front, back), {}, query(kProduct, true, front, back)};
    default:
      return {query(kRadii, true, front, back), query(kRight, false, front, back),
              query(kProduct, false, front, back)};
  }
}

std::size_t DiscGaps::bytes() const {
  std::size_t sum = 0;
  for (const Signed& term : terms_) sum += term.plus.bytes() + term.minus.bytes();
  return sum;
}

}  // namespace kinex
