// SPDX-License-Identifier: GPL-3.0-or-later
// Sines and cosines without floating point, by series in fixed-point numbers: the same on every
// machine.
#ifndef KINEX_EXPERIMENTS_FORMATS_ANGLES_H
#define KINEX_EXPERIMENTS_FORMATS_ANGLES_H

#include "core/numbers/rational.h"

namespace kinex::formats {

// The multiple of 2^-bits nearest to `value`.
Rational rounded(const Rational& value, unsigned long bits);
// Approximations to about 2^-60.
Rational approximate_pi();
Rational approximate_root(const Rational& square);  // square >= 0
struct CosSin {
  Rational cos, sin;
};
CosSin approximate_cos_sin(const Rational& angle);  // 0 <= angle <= 2

}  // namespace kinex::formats

#endif
