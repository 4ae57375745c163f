// SPDX-License-Identifier: GPL-3.0-or-later
// `mpfr:P`: MPFR numbers of P bits, rounded to nearest, no intervals, for the trade-off between
// speed and accuracy. The algorithms are those of `double`. No guarantee.
#ifndef KINEX_CORE_ARITHMETIC_MPFR_ARITHMETIC_H
#define KINEX_CORE_ARITHMETIC_MPFR_ARITHMETIC_H

#include <memory>

#include "core/arithmetic/arithmetic.h"

namespace kinex {

// 2 <= bits <= 100000.
std::unique_ptr<Arithmetic> make_mpfr_arithmetic(const Scene& scene, const NumberNeeds& needs,
                                                 long bits);

}  // namespace kinex

#endif
