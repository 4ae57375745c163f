// SPDX-License-Identifier: GPL-3.0-or-later
// `double`: the filter's algorithms in plain IEEE doubles, with no error accounting. It guarantees
// nothing. It is the best arithmetic in doubles that answers one question at a time, so that comparisons
// with `exact` are fair; `exact` itself examines the certificates of an event side by side.
#ifndef KINEX_CORE_ARITHMETIC_DOUBLE_ARITHMETIC_H
#define KINEX_CORE_ARITHMETIC_DOUBLE_ARITHMETIC_H

#include <memory>

#include "core/arithmetic/arithmetic.h"

namespace kinex {

std::unique_ptr<Arithmetic> make_double_arithmetic(const Scene& scene,
                                                  const NumberNeeds& needs);  // `double`

}  // namespace kinex

#endif
