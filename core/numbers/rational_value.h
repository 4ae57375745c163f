// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether a real root is rational.
#ifndef KINEX_CORE_NUMBERS_RATIONAL_VALUE_H
#define KINEX_CORE_NUMBERS_RATIONAL_VALUE_H

#include <optional>

#include "core/numbers/real_root.h"

namespace kinex {

// The value of the root if it is rational, in either representation; nullopt if it is irrational.
// The denominator of a rational root divides the leading coefficient c, so c * root is an integer:
// the interval is narrowed until it contains at most one candidate.
std::optional<Rational> rational_value(RealRoot& root, RootCounters& counters);

}  // namespace kinex

#endif
