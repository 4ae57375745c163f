// SPDX-License-Identifier: GPL-3.0-or-later
// CoordinateDifference: a predicate of two objects whose value is the coordinate of the second minus
// that of the first, on one axis. Searches in an order need many such signs at one instant: an
// arithmetic that knows the predicate as a difference subtracts two motions and calls no formula.
#ifndef KINEX_CORE_ARITHMETIC_COORDINATE_DIFFERENCE_H
#define KINEX_CORE_ARITHMETIC_COORDINATE_DIFFERENCE_H

namespace kinex {

// A second base class of those predicates.
class CoordinateDifference {
 public:
  virtual ~CoordinateDifference() = default;
  virtual int difference_axis() const = 0;
};

}  // namespace kinex

#endif
