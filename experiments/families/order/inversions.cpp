// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/order/inversions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/families/points/lines.h"

namespace kinex::families {

namespace {

// Sorts by `less` and counts how many pairs were out of order. Merge sort.
template <class Less>
std::uint64_t sort_counting(std::vector<std::size_t>& items, std::size_t begin, std::size_t end,
                            std::vector<std::size_t>& work, const Less& less) {
  if (end - begin < 2) return 0;
  const std::size_t middle = begin + (end - begin) / 2;
  std::uint64_t count = sort_counting(items, begin, middle, work, less) +
                        sort_counting(items, middle, end, work, less);
  std::size_t a = begin, b = middle, out = begin;
  while (a < middle || b < end) {
    if (b == end || (a < middle && !less(items[b], items[a]))) {
      work[out++] = items[a++];
    } else {
      count += middle - a;
      work[out++] = items[b++];
    }
  }
  std::copy(work.begin() + static_cast<std::ptrdiff_t>(begin),
            work.begin() + static_cast<std::ptrdiff_t>(end),
            items.begin() + static_cast<std::ptrdiff_t>(begin));
  return count;
}

}  // namespace

Integer inversions(const Scene& scene) {
  const std::vector<Line> lines = lines_of(scene, false);
  std::vector<std::size_t> order(lines.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    if (lines[i].value != lines[j].value) return lines[i].value < lines[j].value;
    if (lines[i].slope != lines[j].slope) return lines[i].slope < lines[j].slope;
    return i < j;
  });
  std::vector<Rational> last;  // decides the order at the end
  for (const Line& line : lines) {
    last.push_back(scene.end ? line.value + line.slope * (*scene.end - scene.start) : line.slope);
  }
  const auto before_at_end = [&](std::size_t i, std::size_t j) {
    if (last[i] != last[j]) return last[i] < last[j];
    if (lines[i].slope != lines[j].slope) return lines[i].slope < lines[j].slope;
    if (lines[i].value != lines[j].value) return lines[i].value < lines[j].value;
    return i < j;
  };
  std::vector<std::size_t> work(order.size());
  return static_cast<std::int64_t>(sort_counting(order, 0, order.size(), work, before_at_end));
}

}  // namespace kinex::families
