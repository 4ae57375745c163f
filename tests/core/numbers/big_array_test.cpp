// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/big_array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

#include "tests/sanitized.h"

namespace kinex {
namespace big_array_test {

bool starts_a_page(const void* memory) {
  return reinterpret_cast<std::uintptr_t>(memory) % huge_pages::kPage == 0;
}

TEST(BigArray, KeepsItsValuesWhenItMovesToHugePagesAndBack) {
  const std::size_t large = huge_pages::kLeast / sizeof(std::uint64_t);
  BigArray<std::uint64_t> array;
  for (std::uint64_t i = 0; i < 3 * large; ++i) array.push_back(i);
  EXPECT_TRUE(starts_a_page(array.data()));
  BigArray<std::uint64_t> copy = array;
  EXPECT_TRUE(starts_a_page(copy.data()));
  EXPECT_EQ(copy, array);
  array.resize(5);
  array.shrink_to_fit();
  EXPECT_EQ(array, (BigArray<std::uint64_t>{0, 1, 2, 3, 4}));
  const std::uint64_t* const place = copy.data();
  const BigArray<std::uint64_t> moved = std::move(copy);
  EXPECT_EQ(moved.data(), place);
  for (std::uint64_t i = 0; i < moved.size(); ++i) ASSERT_EQ(moved[i], i);
}

TEST(BigArray, TakesHugePagesFromTheLeastSizeOn) {
  const BigArray<char> small(huge_pages::kLeast - 1), large(huge_pages::kLeast);
  EXPECT_TRUE(starts_a_page(large.data()));
  EXPECT_EQ(std::accumulate(small.begin(), small.end(), 0), 0);
}

TEST(BigArray, RefusesWhatNoMemoryHolds) {
  if (test::kSanitized) GTEST_SKIP() << "AddressSanitizer ends the program";
  HugePageAllocator<std::uint64_t> allocator;
  EXPECT_THROW(static_cast<void>(allocator.allocate(std::numeric_limits<std::size_t>::max() / 4)),
               std::bad_alloc);
  EXPECT_THROW(static_cast<void>(allocator.allocate(std::size_t{1} << 44)), std::bad_alloc);
}

}  // namespace big_array_test
}  // namespace kinex
