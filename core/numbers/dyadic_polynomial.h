// SPDX-License-Identifier: GPL-3.0-or-later
// DyadicPolynomial: polynomials with short dyadic coefficients, in machine integers.
//
// Coefficients are 128-bit integers over one power of two. Every operation first proves by bit
// lengths that nothing overflows. If it cannot, the result is invalid, and so is everything
// computed from it. No heap. Cost: O(size) for a sum, O(size^2) for a product.
#ifndef KINEX_CORE_NUMBERS_DYADIC_POLYNOMIAL_H
#define KINEX_CORE_NUMBERS_DYADIC_POLYNOMIAL_H

#include <array>
#include <cstddef>
#include <vector>

#include "core/numbers/integer.h"
#include "core/numbers/rational.h"

namespace kinex {

class DyadicPolynomial {
 public:
  static constexpr std::size_t kRoom = 8;  // coefficients

  // Valid iff there are 1 to kRoom coefficients, all denominators are powers of two, and all
  // numerators and denominators fit 64-bit signed integers. Low degree first.
  static DyadicPolynomial of(const std::vector<Rational>& coefficients);

  bool is_valid() const { return valid_; }
  // log2 of the denominator that unreduced fractions would have. For a product it is the sum of
  // both; for a sum, too, unless both are equal. At least the exponent of the stored coefficients.
  unsigned denominator_bits() const { return denominator_bits_; }
  // An upper bound on the bit lengths of the coefficients times 2^common. Requires common >=
  // denominator_bits().
  std::size_t bits(unsigned common) const { return bits_ + (common - exponent_); }
  // Writes the coefficients times 2^common, trailing zeros stripped, at least one. Requires
  // is_valid() and common >= denominator_bits().
  void write(unsigned common, std::vector<Rational>& out) const;

  friend DyadicPolynomial operator+(const DyadicPolynomial& a, const DyadicPolynomial& b) {
    return sum(a, b, false);
  }
  friend DyadicPolynomial operator-(const DyadicPolynomial& a, const DyadicPolynomial& b) {
    return sum(a, b, true);
  }
  friend DyadicPolynomial operator*(const DyadicPolynomial& a, const DyadicPolynomial& b);

 private:
  static constexpr unsigned kMostBits = 126;
  static DyadicPolynomial sum(const DyadicPolynomial& a, const DyadicPolynomial& b, bool minus);
  void measure();

  std::array<Int128, kRoom> c_{};
  std::size_t size_ = 0;
  unsigned bits_ = 0;              // the largest bit length of the coefficients
  unsigned exponent_ = 0;          // coefficient i is c_[i] / 2^exponent_
  unsigned denominator_bits_ = 0;  // >= exponent
  bool valid_ = false;
};

}  // namespace kinex

#endif
