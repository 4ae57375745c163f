// SPDX-License-Identifier: GPL-3.0-or-later
// `double`: the filter's algorithms in plain IEEE doubles, with no error accounting. It is the best
// floating-point kinetic arithmetic that we can write, and so a fair rival of `exact`. No
// guarantee.
#ifndef KINEX_CORE_ARITHMETIC_DOUBLE_ARITHMETIC_H
#define KINEX_CORE_ARITHMETIC_DOUBLE_ARITHMETIC_H

#include <memory>

#include "core/arithmetic/arithmetic.h"

namespace kinex {

std::unique_ptr<Arithmetic> make_double_arithmetic(const Scene& scene,
                                                  const NumberNeeds& needs);  // `double`

}  // namespace kinex

#endif
