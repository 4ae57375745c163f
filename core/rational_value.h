// SPDX-License-Identifier: GPL-3.0-or-later
// Is a real root a rational number?
#ifndef KINEX_CORE_RATIONAL_VALUE_H
#define KINEX_CORE_RATIONAL_VALUE_H

#include <optional>

#include "core/real_root.h"

namespace kinex {

// The value of the root if it is rational, however it is represented; nullopt if it is not.
// A rational root of an integer polynomial has a denominator that divides the leading coefficient
// c, so c * root is an integer: the interval is narrowed until it leaves room for one candidate.
std::optional<Rational> rational_value(RealRoot& root, RootCounters& counters);

}  // namespace kinex

#endif
