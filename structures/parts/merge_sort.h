// SPDX-License-Identifier: GPL-3.0-or-later
// merge_sort: sorts by a comparison that may contradict itself.
//
// In an inexact arithmetic the signs of certificates need not be an order. std::sort may then read
// beyond its range; a merge sort ends anyway, with some permutation.
#ifndef KINEX_STRUCTURES_PARTS_MERGE_SORT_H
#define KINEX_STRUCTURES_PARTS_MERGE_SORT_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kinex {

// Stable. O(n log n) calls of before(b, a), with a before b in the given order.
template <class T, class Before>
void merge_sort(std::vector<T>& items, const Before& before) {
  std::vector<T> scratch(items.size());
  for (std::size_t width = 1; width < items.size(); width *= 2) {
    for (std::size_t begin = 0; begin < items.size(); begin += 2 * width) {
      const std::size_t middle = std::min(begin + width, items.size());
      const std::size_t end = std::min(begin + 2 * width, items.size());
      std::size_t a = begin, b = middle;
      for (std::size_t out = begin; out < end; ++out) {
        const bool take_b = b < end && (a == middle || before(items[b], items[a]));
        scratch[out] = items[take_b ? b++ : a++];
      }
    }
    items.swap(scratch);
  }
}

}  // namespace kinex

#endif
