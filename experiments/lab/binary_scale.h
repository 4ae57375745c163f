// SPDX-License-Identifier: GPL-3.0-or-later
// Exact rationals on the binary scale: logarithms, units in the last place, rounding to P bits.
#ifndef KINEX_EXPERIMENTS_LAB_BINARY_SCALE_H
#define KINEX_EXPERIMENTS_LAB_BINARY_SCALE_H

#include "core/numbers/rational.h"

namespace kinex::lab {

// 2^k, for any k.
Rational power_of_two(long k);
Rational absolute(Rational x);
// The largest k with 2^k <= x, and the smallest k with x <= 2^k: exact. Requires x > 0.
long floor_log2(const Rational& x);
long ceil_log2(const Rational& x);
// The number of `bits` significant bits nearest to x (ties to even).
Rational round_to_bits(const Rational& x, long bits);
// The distance between neighbouring binary64 numbers around x: 2^(floor(log2 |x|) - 52), or 2^-1074
// for |x| below 2^-1022, zero included.
Rational ulp_of(const Rational& x);

}  // namespace kinex::lab

#endif
