// SPDX-License-Identifier: GPL-3.0-or-later
// The floating-point filter for signs: the sign of a polynomial on all of a short interval, certified in
// doubles. The error model, and c and m, are those of core/numbers/first_root.h.
#ifndef KINEX_CORE_NUMBERS_INTERVAL_SIGN_H
#define KINEX_CORE_NUMBERS_INTERVAL_SIGN_H

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/numbers/first_root.h"
#include "core/numbers/sign.h"

namespace kinex::filter {

struct Interval {  // of times t - origin
  double lo;
  double hi;
  double width;  // hi - lo, which may be less than the difference of the rounded ends
};

// The sign on all of the interval, if it is certainly constant.
//
// D >= 0: the degree, known at compile time; D < 0: the degree is given at run time.
template <int D>
[[gnu::always_inline]] inline std::optional<Sign> sign_over(const double* c, const double* m,
                                                            int degree, const Interval& interval) {
  const int d = D >= 0 ? D : degree;
  const double t = interval.hi;
  const double bound = std::max(std::fabs(interval.lo), std::fabs(t));
  double value = c[d], magnitude = m[d], slope = d * m[d];
  for (int i = d - 1; i >= 0; --i) {
    value = value * t + c[i];
    magnitude = magnitude * bound + m[i];
    if (i > 0) slope = slope * bound + i * m[i];
  }
  if (d == 0) slope = 0;
  if (!(magnitude >= 0x1p-300 && magnitude <= 0x1p900 && bound <= 0x1p200)) return std::nullopt;
  // Most bounds are below the limit of the largest degree, which needs no power.
  if (d > 3 && !(bound <= kLeastTimeLimit) && !(bound <= std::exp2(600.0 / d))) return std::nullopt;
  // The value moves by at most slope * width in the interval.
  const double error = gamma(d) * magnitude + slope * interval.width * (1 + 0x1p-20);
  if (value > error) return Sign::kPositive;
  if (value < -error) return Sign::kNegative;
  if (interval.width == 0 || !(std::fabs(value) > gamma(d) * magnitude)) return std::nullopt;
  // Where terms cancel the coefficients are far smaller than their bounds: |c_j| + gamma m_j is closer.
  double steep = d * std::fabs(c[d]);
  for (int i = d - 1; i > 0; --i) steep = steep * bound + i * std::fabs(c[i]);
  const double closer =
      gamma(d) * magnitude + (steep + 2 * gamma(d) * slope) * interval.width * (1 + 0x1p-20);
  if (value > closer) return Sign::kPositive;
  if (value < -closer) return Sign::kNegative;
  return std::nullopt;
}

}  // namespace kinex::filter

#endif
