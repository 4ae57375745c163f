// SPDX-License-Identifier: GPL-3.0-or-later
// First sign change of a polynomial in MPFR numbers: the Bernstein bisection of
// core/numbers/first_root.h with no error accounting, for any precision and degree.
#ifndef KINEX_CORE_ARITHMETIC_MPFR_FIRST_ROOT_H
#define KINEX_CORE_ARITHMETIC_MPFR_FIRST_ROOT_H

#include <optional>
#include <vector>

#include "core/numbers/mp_float.h"

namespace kinex {

// The first root in (a, b] at which the sign changes, as far as this precision shows; nullopt if
// none is found. c: low degree first, degree >= 1; positive right after a. `b` unset: no limit.
std::optional<MpFloat> mpfr_first_sign_change(const std::vector<MpFloat>& c, const MpFloat& a,
                                              const std::optional<MpFloat>& b);

// The value and the first derivative at t.
MpFloat mpfr_value(const std::vector<MpFloat>& c, const MpFloat& t);
MpFloat mpfr_slope(const std::vector<MpFloat>& c, const MpFloat& t);

// How far from t a root that is rounded to t may seem to lie: the rounding error of the value at t,
// divided by the slope. At least 16 units in the last place of t. At most half of its digits, since
// the slope is no guide next to a multiple root. 0 for t = 0.
MpFloat mpfr_root_doubt(const std::vector<MpFloat>& c, const MpFloat& t);

}  // namespace kinex

#endif
