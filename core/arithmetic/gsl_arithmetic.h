// SPDX-License-Identifier: GPL-3.0-or-later
// `gsl`: doubles with GSL's polynomial solvers, the usual floating-point arithmetic of kinetic
// software. It never crashes, loops or returns a NaN; it guarantees nothing else.
//
// GSL's error handler is one pointer per process, and by default it aborts the process. Making the
// first arithmetic of this kind turns it off for good (once, thread-safe).
#ifndef KINEX_CORE_ARITHMETIC_GSL_ARITHMETIC_H
#define KINEX_CORE_ARITHMETIC_GSL_ARITHMETIC_H

#include <memory>

#include "core/arithmetic/arithmetic.h"

namespace kinex {

std::unique_ptr<Arithmetic> make_gsl_arithmetic(const Scene& scene,
                                                  const NumberNeeds& needs);  // `gsl`

}  // namespace kinex

#endif
