// SPDX-License-Identifier: GPL-3.0-or-later
// An instant rounded down to a double of 40 significant bits, independent of the width of the
// interval in which the instant is known to lie.
#ifndef KINEX_CORE_NUMBERS_ROUNDED_INSTANT_H
#define KINEX_CORE_NUMBERS_ROUNDED_INSTANT_H

#include <cmath>

#include "core/numbers/exactly.h"
#include "core/numbers/rational.h"

namespace kinex {

inline double rounded_down(double t) {  // of a double
  constexpr int kBits = 40;
  if (t == 0 || !std::isfinite(t)) return t;
  int exponent = 0;
  const double mantissa = std::frexp(t, &exponent);
  return std::ldexp(std::floor(std::ldexp(mantissa, kBits)), exponent - kBits);
}

// `Instant` has lower() and upper(), equal once it is known to be rational. `compare` gives the
// exact order of it and a rational; `refine` narrows it.
template <class Instant, class Compare, class Refine>
double rounded_down(Instant& instant, const Compare& compare, const Refine& refine) {
  if (instant.lower().sign() < 0 && instant.upper().sign() > 0 && compare(Rational()) == 0) {
    return 0;
  }
  for (;;) {
    const double low = rounded_down(instant.lower().lower_double());
    const double high = rounded_down(instant.upper().lower_double());
    // Below all doubles it is -infinity.
    if (low == high || !std::isfinite(high) || compare(exactly(high)) >= 0) return high;
    refine();
  }
}

}  // namespace kinex

#endif
