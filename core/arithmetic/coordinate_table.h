// SPDX-License-Identifier: GPL-3.0-or-later
// CoordinateTable: the linear motions of many objects along one axis, side by side in memory: for a
// search that compares one object with many at one instant (Arithmetic::signs_after). Motions lie far
// apart, in the order of their objects; such a search would wait for each of them.
//
// Only arithmetics look inside. A search holds a table beside the list of its objects.
#ifndef KINEX_CORE_ARITHMETIC_COORDINATE_TABLE_H
#define KINEX_CORE_ARITHMETIC_COORDINATE_TABLE_H

#include <cstddef>

#include "core/numbers/big_array.h"

namespace kinex {

class CoordinateTable {
 public:
  std::size_t bytes() const {
    return (heights_.capacity() + slopes_.capacity()) * sizeof(heights_[0]);
  }
  // Prefetches the motion at a place, if there is one.
  void prefetch(std::size_t place) const {
    if (place >= heights_.size()) return;
    __builtin_prefetch(&heights_[place]);
    __builtin_prefetch(&slopes_[place]);
  }

 private:
  friend class ExactArithmetic;

  // The coordinate at t is (height_ + heights_[place]) + (slope_ + slopes_[place]) t. The numbers in
  // parentheses are off by height_error_ and slope_error_, and by half a unit in the last place of a
  // float, at most. Empty: there is nothing to look up.
  BigArray<float> heights_, slopes_;
  double height_ = 0, slope_ = 0;
  double height_error_ = 0, slope_error_ = 0;
};

}  // namespace kinex

#endif
