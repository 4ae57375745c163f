// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/merge_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace kinex::test {
namespace merge_sort_test {

TEST(MergeSort, SortsStably) {
  std::mt19937 random(1);
  for (std::size_t n = 0; n < 70; ++n) {
    std::vector<std::pair<int, std::size_t>> items;
    for (std::size_t i = 0; i < n; ++i) items.emplace_back(static_cast<int>(random() % 5), i);
    std::vector<std::pair<int, std::size_t>> expected = items;
    std::sort(expected.begin(), expected.end());
    std::size_t calls = 0;
    merge_sort(items, [&](const auto& a, const auto& b) {
      ++calls;
      return a.first < b.first;
    });
    EXPECT_EQ(items, expected);
    std::size_t levels = 0;
    while (std::size_t{1} << levels < n) ++levels;
    EXPECT_LE(calls, n * levels);
  }
}

TEST(MergeSort, EndsWithAPermutationWhateverTheComparisonSays) {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    std::vector<int> items(1 + random() % 60);
    std::iota(items.begin(), items.end(), 0);
    const std::vector<int> expected = items;
    merge_sort(items, [&](int, int) { return random() % 2 == 0; });
    std::sort(items.begin(), items.end());
    EXPECT_EQ(items, expected);
  }
}

}  // namespace merge_sort_test
}  // namespace kinex::test
