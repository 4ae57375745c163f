// SPDX-License-Identifier: GPL-3.0-or-later
// Separates two roots that are much closer to each other than to anything else.
#ifndef KINEX_CORE_CLOSE_PAIR_H
#define KINEX_CORE_CLOSE_PAIR_H

#include <optional>

#include "core/real_root.h"

namespace kinex {

// Dyadic ends that are no roots, lower < upper; first_upper <= second_lower.
struct ClosePair {
  Rational first_lower, first_upper;
  Rational second_lower, second_upper;
};

// Requires: lower < upper dyadic, p has the same sign at both, p' exactly one root between them, a
// simple one, and p is not zero there (p has no multiple root). The two roots of p between lower
// and upper, or nullopt if p has none. Bisection would take as many steps as there are bits in the
// distance of the roots; the root of p' is approximated in a number of steps logarithmic in that.
std::optional<ClosePair> separate_close_pair(const Polynomial& p, const Rational& lower,
                                             const Rational& upper, RootCounters& counters);

}  // namespace kinex

#endif
