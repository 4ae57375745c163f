// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a root of an integer polynomial is rational: decided exactly.
#ifndef KINEX_CORE_RATIONAL_ROOT_H
#define KINEX_CORE_RATIONAL_ROOT_H

#include <optional>

#include "core/real_root.h"

namespace kinex {

// True: the polynomial has no rational root, because it has none (nor one at infinity) modulo one
// of the primes below 50. False says nothing. `c`: at least two coefficients. Of polynomials
// without rational roots and without structure some 99.7 % are found to be so, in 3 primes on the
// average.
bool lacks_rational_roots(const std::vector<Integer>& c);

// The fraction with the least denominator in [lo, hi], if its numerator and denominator fit 52
// bits: a guess, as it is made in doubles.
std::optional<Rational> simplest_fraction(double lo, double hi);

// The root's value, if it is rational; refines it until that is decided. p(root) = 0; p canonical.
// A rational root's denominator divides the leading coefficient, so that the interval soon holds
// one candidate at most.
std::optional<Rational> rational_value(const Polynomial& p, RealRoot& root, RootCounters& counters);

}  // namespace kinex

#endif
