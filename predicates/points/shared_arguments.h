// SPDX-License-Identifier: GPL-3.0-or-later
// SharedArguments: a predicate some of whose arguments are the same object.
//
// A certificate may not name an object twice. SharedArguments takes each object once; `pattern`
// gives the object of each argument of the whole predicate:
//
//   order_strip(a, b, c, d, e, f)  with d = b, e = c:   objects a, b, c, f
//   pattern 0 1 2 1 2 3                                 named order_strip/012123
//
//   (1) value(objects) = value of the whole of (objects[pattern[0]], objects[pattern[1]], ..)
//   (2) if exchanging the two halves of its arguments negates the whole predicate, then exchanging
//       the two halves of the pattern gives the opposite predicate
// The degree, the error bounds and the unit are those of the whole.
#ifndef KINEX_PREDICATES_POINTS_SHARED_ARGUMENTS_H
#define KINEX_PREDICATES_POINTS_SHARED_ARGUMENTS_H

#include <cstdint>
#include <memory>
#include <span>

#include "core/arithmetic/predicate.h"

namespace kinex {

// `pattern`: one number for each argument of `whole`; together they are 0 .. k - 1 for some k.
// Throws std::invalid_argument otherwise.
std::shared_ptr<const Predicate> make_shared_arguments(std::shared_ptr<const Predicate> whole,
                                                       std::span<const std::uint8_t> pattern);

}  // namespace kinex

#endif
