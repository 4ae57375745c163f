// SPDX-License-Identifier: GPL-3.0-or-later
// Decides exactly whether a root of an integer polynomial is rational.
#ifndef KINEX_CORE_NUMBERS_RATIONAL_ROOT_H
#define KINEX_CORE_NUMBERS_RATIONAL_ROOT_H

#include <optional>

#include "core/numbers/real_root.h"

namespace kinex {

// True: the polynomial has no rational root, because it has no root (nor one at infinity) modulo
// one of the primes below 100. False proves nothing. `c`: at least two coefficients. Detects about
// 99.99 % of unstructured polynomials without rational roots, with 3 primes on average.
bool lacks_rational_roots(const std::vector<Integer>& c);

// The fraction with the least denominator in [lo, hi], if its numerator and denominator fit 52
// bits. Computed in doubles: a guess.
std::optional<Rational> simplest_fraction(double lo, double hi);

// The root's value if it is rational, else nullopt; refines the root until that is decided.
// Requires p(root) = 0, p canonical. A rational root's denominator divides the leading coefficient,
// so the interval soon contains at most one candidate.
std::optional<Rational> rational_value(const Polynomial& p, RealRoot& root, RootCounters& counters);

}  // namespace kinex

#endif
