// SPDX-License-Identifier: GPL-3.0-or-later
// Separates two roots that are much closer to each other than to anything else.
#ifndef KINEX_CORE_NUMBERS_CLOSE_PAIR_H
#define KINEX_CORE_NUMBERS_CLOSE_PAIR_H

#include <optional>

#include "core/numbers/real_root.h"

namespace kinex {

// Two isolating intervals: dyadic ends that are not roots, lower < upper, first_upper <= second_lower.
struct ClosePair {
  Rational first_lower, first_upper;
  Rational second_lower, second_upper;
};

// The two roots of p between lower and upper, or nullopt if p has none.
//
//      +  \                 / +       p at lower and upper
//   -------\-.-----------.-/-----     the two roots
//             '-._____.-'             the root of p' between them
//
// Requires: lower < upper dyadic; p has the same sign at both; p' has exactly one root between
// them, a simple one; p is not zero at that root (p has no multiple root).
// Cost: steps logarithmic in the number of bits of the distance of the roots, to approximate the
// root of p'; bisection would take as many steps as there are bits.
std::optional<ClosePair> separate_close_pair(const Polynomial& p, const Rational& lower,
                                             const Rational& upper, RootCounters& counters);

}  // namespace kinex

#endif
