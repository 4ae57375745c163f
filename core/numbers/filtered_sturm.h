// SPDX-License-Identifier: GPL-3.0-or-later
// FilteredSturm: the Sturm sequence of a polynomial in doubles with proved error bounds.
//
// Each element is, up to a positive factor, the negated remainder of the two before it. Where p is
// not zero at a < b, it has variations(a) - variations(b) roots between them:
//
//   p = x^3 - 3x + 1                x = -inf   -2    0    2      roots: -1.88, 0.35, 1.53
//   p_0 = p                               -     -    +    +
//   p_1 ~ p'             = x^2 - 1        +     +    -    +
//   p_2 ~ -(p_0 mod p_1) = 2x - 1         -     -    -    +
//   p_3 ~ -(p_1 mod p_2) = 1              +     +    +    +
//   variations                            3     3    2    0      1 root in (-2, 0), 2 in (0, 2)
//
// Source: Sturm's theorem, as in core/numbers/sturm_sequence.h. Every answer is a proof; where
// doubles cannot decide, there is no answer. A sequence that could be made proves that the
// polynomial is square-free: its last element is a constant that is certainly not zero.
// Cost: O(degree^2) double operations for a sequence, and as many for a count. No heap.
//
// Error model:
//   (1) The exact coefficients of every element, up to a positive constant, differ from
//       Element::value by at most Element::error.
//   (2) An operation rounds by at most u|result|, u = 2^-53.
//   (3) Every error is a sum of non-negative terms, computed with at most eight roundings, which
//       kInflate compensates.
//   (4) Underflow: non-zero values lie between 2^-400 and 1 at the start of every division, and
//       quotients below 2^-400 are refused, so no product of three falls below 2^-1100.
#ifndef KINEX_CORE_NUMBERS_FILTERED_STURM_H
#define KINEX_CORE_NUMBERS_FILTERED_STURM_H

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/numbers/integer.h"

namespace kinex {

class FilteredSturm {
 public:
  static constexpr int kMostDegree = 16;

  // The sequence of p(2^scale x), a polynomial in x; p is low degree first, without a leading zero.
  // False: it could not be made with certainty, or the degree is not 1 to kMostDegree. The counts
  // are then undefined.
  bool make(const std::vector<Integer>& p, long scale);

  // The number of sign changes along the sequence at x; nullopt if a sign is not certain (always at
  // a root of an element), or if |x| > 2^32. Requires a successful make().
  std::optional<int> variations(double x) const;
  int variations_at_minus_infinity() const { return at_minus_infinity_; }

 private:
  static constexpr std::size_t kRoom = kMostDegree + 1;
  struct Element {
    int degree = -1;
    std::array<double, kRoom> value;
    std::array<double, kRoom> error;
  };

  bool set_first(const std::vector<Integer>& p, long scale);
  void set_derivative();
  // -(a mod b), scaled to at most 1; false if its degree is not certain, or if it is zero.
  static bool divide(const Element& a, const Element& b, Element& rest);

  std::array<Element, kMostDegree + 1> sequence_;
  std::size_t size_ = 0;
  int at_minus_infinity_ = 0;
};

}  // namespace kinex

#endif
