// SPDX-License-Identifier: GPL-3.0-or-later
// Names of instants for the `sturm` arithmetic, by plain bisection and Sturm counts. The same names
// as those of RootNamer and name_root, from code that shares none of their root finding; only
// digits are computed and written in one place (core/numbers/instant_digits.h).
#ifndef KINEX_CORE_ARITHMETIC_STURM_NAME_H
#define KINEX_CORE_ARITHMETIC_STURM_NAME_H

#include "core/arithmetic/sturm_instant.h"
#include "core/numbers/instant_name.h"

namespace kinex {

// Fills in everything but number, detail and exact. p vanishes at `instant`; p not zero.
void name_by_sturm(const RationalPolynomial& p, SturmInstant instant, InstantName& name);

// The interval and the decimal of InstantDetail::kInterval.
void enclose_by_sturm(SturmInstant instant, InstantName& name);

}  // namespace kinex

#endif
