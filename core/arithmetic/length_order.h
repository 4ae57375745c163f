// SPDX-License-Identifier: GPL-3.0-or-later
// LengthOrder: a predicate that compares two squared lengths. Its value is |u|^2 - |v|^2 for two
// differences u, v of its arguments, over all its axes. Closest pairs, spanning trees and tournaments of
// distances ask for little else: an arithmetic that knows the predicate as such an order calls no formula.
#ifndef KINEX_CORE_ARITHMETIC_LENGTH_ORDER_H
#define KINEX_CORE_ARITHMETIC_LENGTH_ORDER_H

#include <cstdint>

namespace kinex {

// The arguments between which the differences are taken:
//   u = p(longer_to) - p(longer_from),   v = p(shorter_to) - p(shorter_from).
// longer_from and shorter_from may be the same argument.
struct LengthEnds {
  std::uint8_t shorter_from = 0, shorter_to = 0, longer_from = 0, longer_to = 0;

  constexpr bool share_an_end() const { return longer_from == shorter_from; }
};

// A second base class of those predicates, which have no other arguments. The formula has to be the sum
// of (u - v)(u + v) over the axes, in their order, and its reference
// (core/arithmetic/predicate_formula.h) the argument shorter_from.
class LengthOrder {
 public:
  virtual ~LengthOrder() = default;
  virtual LengthEnds length_ends() const = 0;
};

}  // namespace kinex

#endif
