// SPDX-License-Identifier: GPL-3.0-or-later
// Ball: a double with a proven bound on its error, computed in round-to-nearest. The rounding mode is
// never changed, so no compiler can move an operation across a change of it.
#ifndef KINEX_CORE_NUMBERS_BALL_H
#define KINEX_CORE_NUMBERS_BALL_H

#include <cmath>

namespace kinex {

// The exact value lies in [value - error, value + error]; unknown if either is not finite.
//
// Rounding, with u = 2^-53:
//   (1) Every operation in round-to-nearest is off by at most u|result| + 2^-1075.
//   (2) The errors are themselves computed in floating point. Each `error` below is the sum of at
//       most four non-negative terms with at most five roundings, so it is too small by at most a
//       factor (1 + u)^-6.
//   (3) Using 2u = kUnit instead of u for the rounding of the value would not cover the terms that
//       come from the operands, so the total is inflated by kInflate = 1 + 16u.
//   (4) kTiny covers underflow of any of the (at most six) products. It is far above 2^-1022: the errors
//       of zeros, and what is computed with them, would be subnormal numbers below, and operations with
//       these take twenty times as long on some processors.
struct Ball {
  static constexpr double kUnit = 0x1p-52;
  static constexpr double kInflate = 1.0 + 0x1p-49;
  static constexpr double kTiny = 0x1p-900;

  double value = 0;
  double error = 0;

  friend Ball operator+(const Ball& a, const Ball& b) {
    const double v = a.value + b.value;
    return {v, (a.error + b.error + kUnit * std::fabs(v)) * kInflate};
  }
  friend Ball operator-(const Ball& a, const Ball& b) {
    const double v = a.value - b.value;
    return {v, (a.error + b.error + kUnit * std::fabs(v)) * kInflate};
  }
  friend Ball operator*(const Ball& a, const Ball& b) {
    const double v = a.value * b.value;
    return {v, (std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error +
                kUnit * std::fabs(v)) *
                       kInflate +
                   kTiny};
  }
  Ball& operator+=(const Ball& b) { return *this = *this + b; }
  Ball& operator-=(const Ball& b) { return *this = *this - b; }
};

}  // namespace kinex

#endif
