// SPDX-License-Identifier: GPL-3.0-or-later
// CoordinateTable: the linear motions of many objects along one axis, side by side in memory: for a
// search that compares one object with many at one instant (Arithmetic::signs_after), or with both
// ends of an interval (Arithmetic::out_of_interval). Motions lie far
// apart, in the order of their objects; such a search would wait for each of them.
//
// Only arithmetics look inside. A search holds a table beside the list of its objects.
#ifndef KINEX_CORE_ARITHMETIC_COORDINATE_TABLE_H
#define KINEX_CORE_ARITHMETIC_COORDINATE_TABLE_H

#include <cstddef>
#include <cstdint>

#include "core/numbers/big_array.h"

namespace kinex {

// Which of up to kMost objects are out of a closed interval: bit i is for the i-th one.
struct OutOfInterval {
  static constexpr std::size_t kMost = 64;
  std::uint64_t before = 0, after = 0;  // less than its low end; more than its high end

  // The bits of the first `size` objects.
  static std::uint64_t all(std::size_t size) {
    return size == 0 ? 0 : ~std::uint64_t{0} >> (kMost - size);
  }
};

class CoordinateTable {
 public:
  std::size_t bytes() const {
    return (heights_.capacity() + slopes_.capacity()) * sizeof(heights_[0]);
  }
  // Prefetches the motions at `count` places, as far as there are any.
  void prefetch(std::size_t place, std::size_t count) const {
    constexpr std::size_t kLine = 16;  // floats of a cache line
    if (place + count > heights_.size()) return;
    for (std::size_t i = 0; i < count; i += kLine) {
      __builtin_prefetch(&heights_[place + i]);
      __builtin_prefetch(&slopes_[place + i]);
    }
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
