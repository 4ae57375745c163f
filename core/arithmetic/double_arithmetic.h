// SPDX-License-Identifier: GPL-3.0-or-later
// `double`: the filter's algorithms in plain IEEE doubles, with no error accounting. It guarantees
// nothing. It is the strongest floating-point arithmetic we know how to write, so that comparisons
// with `exact` are fair.
#ifndef KINEX_CORE_ARITHMETIC_DOUBLE_ARITHMETIC_H
#define KINEX_CORE_ARITHMETIC_DOUBLE_ARITHMETIC_H

#include <memory>

#include "core/arithmetic/arithmetic.h"

namespace kinex {

std::unique_ptr<Arithmetic> make_double_arithmetic(const Scene& scene,
                                                  const NumberNeeds& needs);  // `double`

}  // namespace kinex

#endif
