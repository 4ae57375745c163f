// SPDX-License-Identifier: GPL-3.0-or-later
// ValueNumbers against a map, through random calls; and the rule by which numbers are given.
#include "structures/parts/value_numbers.h"

#include <array>
#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace kinex::test {
namespace {

using Pair = std::array<ObjectId, 2>;

TEST(ValueNumbers, FindsWhatIsThere) {
  std::mt19937 random(7);
  ValueNumbers<Pair> numbers;
  std::map<Pair, Item> expected;
  for (int step = 0; step < 20000; ++step) {
    const Pair value{static_cast<ObjectId>(random() % 40), static_cast<ObjectId>(random() % 40)};
    const auto there = expected.find(value);
    ASSERT_EQ(numbers.find(value), there == expected.end() ? kNoItem : there->second);
    if (there == expected.end()) {
      const Item number = numbers.add(value);
      for (const auto& [other, taken] : expected) ASSERT_NE(number, taken);
      expected.emplace(value, number);
    } else if (random() % 2 == 0) {
      numbers.remove(there->second);
      EXPECT_EQ(numbers[there->second], value) << "it has its number until that is released";
      numbers.release(there->second);
      expected.erase(there);
    }
    ASSERT_EQ(numbers.size(), expected.size());
  }
  std::map<Pair, Item> visited;
  numbers.each([&](Item number) { visited.emplace(numbers[number], number); });
  EXPECT_EQ(visited, expected);
}

// No value gets the number of one that was removed and not released; the last one released is the first
// to be given.
TEST(ValueNumbers, GivesNumbersByTheCallsAlone) {
  ValueNumbers<Pair> numbers;
  std::vector<Item> given;
  for (ObjectId i = 0; i < 20; ++i) given.push_back(numbers.add({i, i + 1}));
  for (Item i = 0; i < 20; ++i) EXPECT_EQ(given[i], i);
  for (const Item gone : {4u, 9u, 2u}) numbers.remove(gone);
  EXPECT_EQ(numbers.add({50, 51}), 20u);
  numbers.release(9);
  numbers.release(4);
  EXPECT_EQ(numbers.add({60, 61}), 4u);
  EXPECT_EQ(numbers.add({70, 71}), 9u);
  EXPECT_EQ(numbers.add({80, 81}), 21u) << "2 was not released";
  EXPECT_EQ(numbers.find({4, 5}), kNoItem);
  EXPECT_EQ(numbers.find({60, 61}), 4u);
}

TEST(ValueNumbers, IsEmptyAtFirst) {
  const ValueNumbers<Pair> numbers;
  EXPECT_EQ(numbers.find({1, 2}), kNoItem);
  EXPECT_EQ(numbers.size(), 0u);
}

}  // namespace
}  // namespace kinex::test
