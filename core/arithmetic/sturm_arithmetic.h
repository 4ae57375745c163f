// SPDX-License-Identifier: GPL-3.0-or-later
// `sturm`: rationals and Sturm sequences, no filter. Doubles occur only as the queue's enclosures
// of exactly known instants. It is the reference for `exact`: the same answers, from code that
// shares none of its root finding. Only the digits of instants are computed in a common place.
//
// Failures beyond the scene's end, or beyond the motions of the objects involved, are reported as
// never; one exactly at the end is reported. Cost of a failure time: O(d^2) rational operations for
// the sequence and O(d^2) for each step of the search, on numbers of O(d b) bits for motions of b
// bits.
#ifndef KINEX_CORE_ARITHMETIC_STURM_ARITHMETIC_H
#define KINEX_CORE_ARITHMETIC_STURM_ARITHMETIC_H

#include <memory>

#include "core/arithmetic/arithmetic.h"

namespace kinex {

std::unique_ptr<Arithmetic> make_sturm_arithmetic(const Scene& scene,
                                                  const NumberNeeds& needs);  // `sturm`

}  // namespace kinex

#endif
