// SPDX-License-Identifier: GPL-3.0-or-later
// sort_unique: a list as a set.
#ifndef KINEX_STRUCTURES_PARTS_SORT_UNIQUE_H
#define KINEX_STRUCTURES_PARTS_SORT_UNIQUE_H

#include <algorithm>
#include <vector>

namespace kinex {

// Ascending, each item once. O(n log n).
template <class T>
void sort_unique(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace kinex

#endif
