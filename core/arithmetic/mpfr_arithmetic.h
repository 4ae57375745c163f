// SPDX-License-Identifier: GPL-3.0-or-later
// `mpfr:P`: MPFR numbers of P bits, rounded to nearest, without error bounds. It shows how many
// bits buy how much accuracy, at which cost. The algorithms are those of `double`. No guarantee.
#ifndef KINEX_CORE_ARITHMETIC_MPFR_ARITHMETIC_H
#define KINEX_CORE_ARITHMETIC_MPFR_ARITHMETIC_H

#include <memory>

#include "core/arithmetic/arithmetic.h"

namespace kinex {

// Requires 2 <= bits <= 100000. `needs`: axes and degree (core/arithmetic/number_needs.h).
std::unique_ptr<Arithmetic> make_mpfr_arithmetic(const Scene& scene, const NumberNeeds& needs,
                                                 long bits);

}  // namespace kinex

#endif
