// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/dyadic.h"

#include <algorithm>
#include <utility>

namespace kinex {

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

}  // namespace kinex
