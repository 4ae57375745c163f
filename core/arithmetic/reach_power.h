// SPDX-License-Identifier: GPL-3.0-or-later
// Powers of the reach of a query's points (Predicate::plain_with_reach), which bound its polynomial's
// rounding errors.
//
// All summands are positive, so every order of summation is off by a few units only. R: double, or
// Lanes (core/numbers/lanes.h), in which every lane is as in doubles.
#ifndef KINEX_CORE_ARITHMETIC_REACH_POWER_H
#define KINEX_CORE_ARITHMETIC_REACH_POWER_H

#include "core/arithmetic/predicate.h"
#include "core/numbers/lanes.h"

namespace kinex {

// The coefficients of p^2 for p of degree D.
template <int D, class R>
void square_of(const R* p, R* out) {
  for (int i = 0; i <= 2 * D; ++i) out[i] = 0;
  for (int i = 0; i <= D; ++i) {
    out[2 * i] += p[i] * p[i];
    for (int j = i + 1; j <= D; ++j) out[i + j] += 2 * (p[i] * p[j]);
  }
}

// The coefficients of p q, of degrees D and E.
template <int D, int E, class R>
void product_of(const R* p, const R* q, R* out) {
  for (int i = 0; i <= D + E; ++i) out[i] = 0;
  for (int i = 0; i <= D; ++i) {
    for (int j = 0; j <= E; ++j) out[i + j] += p[i] * q[j];
  }
}

// The coefficients of p^h. Loops of a fixed length are unrolled: this is a good part of a query's time.
template <int D, class R>
void power_of(const R* p, int h, R* out) {
  if (h == 1) {
    for (int i = 0; i <= D; ++i) out[i] = p[i];
    return;
  }
  R squared[2 * D + 1];
  square_of<D>(p, squared);
  if (h == 2) {
    for (int i = 0; i <= 2 * D; ++i) out[i] = squared[i];
    return;
  }
  if (h == 3) return product_of<2 * D, D>(squared, p, out);
  if (h == 4) return square_of<2 * D>(squared, out);
  R fourth[4 * D + 1];
  square_of<2 * D>(squared, fourth);
  if (h == 5) return product_of<4 * D, D>(fourth, p, out);
  product_of<4 * D, 2 * D>(fourth, squared, out);
  for (int k = 6; k < h; ++k) {
    R product[kMaxFixedCoefficients];
    for (int i = 0; i <= (k + 1) * D; ++i) product[i] = 0;
    for (int i = 0; i <= k * D; ++i) {
      for (int j = 0; j <= D; ++j) product[i + j] += out[i] * p[j];
    }
    for (int i = 0; i <= (k + 1) * D; ++i) out[i] = product[i];
  }
}

// The coefficients of (reach[0] + .. + reach[d] t^d)^h, 1 <= d <= kMaxFixedDegree.
inline void reach_power(const double* reach, int d, int h, double* out) {
  switch (d) {
    case 1:
      return power_of<1>(reach, h, out);
    case 2:
      return power_of<2>(reach, h, out);
    default:
      return power_of<3>(reach, h, out);
  }
}

}  // namespace kinex

#endif
