// SPDX-License-Identifier: GPL-3.0-or-later
// Binomial coefficients, for bounds that count triples, quadruples and larger sets of objects.
#ifndef KINEX_STRUCTURES_PARTS_BINOMIAL_H
#define KINEX_STRUCTURES_PARTS_BINOMIAL_H

#include "core/numbers/integer.h"

namespace kinex {

// C(n, k) = n (n - 1) .. (n - k + 1) / k!, the number of sets of k out of n objects; 0 if n < k.
// Requires n >= 0 and k >= 0. Exact, with k products.
Integer binomial(const Integer& n, int k);

}  // namespace kinex

#endif
