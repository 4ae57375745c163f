// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/leaf_sequence.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sanitized.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace leaf_sequence_test {

void expect_order(const LeafSequence& sequence, const std::vector<ObjectId>& expected) {
  EXPECT_EQ(sequence.leaves(), expected);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(sequence.previous(expected[i]), i == 0 ? kNoObject : expected[i - 1]);
  }
}

TEST(LeafSequence, Moves) {
  LeafSequence sequence(5);
  sequence.assign({0, 1, 2, 3, 4});
  LeafSequence::Moves moves{{1, 3}};
  sequence.apply(moves);
  EXPECT_TRUE(moves.empty());
  expect_order(sequence, {0, 2, 3, 1, 4});
  moves = {{0, 4}, {4, kNoObject}};  // the first and the last leaf, one behind the other
  sequence.apply(moves);
  expect_order(sequence, {4, 0, 2, 3, 1});
  moves = {{2, 0}, {3, 2}};  // nothing changes
  sequence.apply(moves);
  expect_order(sequence, {4, 0, 2, 3, 1});
}

// Some leaves are put anywhere; what each is behind then determines the order.
TEST(LeafSequence, AnyLeavesMoveAnywhere) {
  for (std::uint64_t seed = 1; seed <= test::fewer(300u); ++seed) {
    Random random(seed);
    const int n = random.between(1, 12);
    std::vector<ObjectId> order;
    for (int i = 0; i < n; ++i) order.push_back(static_cast<ObjectId>(i));
    LeafSequence sequence(order.size());
    sequence.assign(order);
    std::vector<ObjectId> moved;
    for (int i = 0; i < n; ++i) {
      if (!random.chance(40)) continue;
      moved.push_back(static_cast<ObjectId>(i));
      order.erase(std::find(order.begin(), order.end(), moved.back()));
      order.insert(order.begin() + random.between(0, static_cast<int>(order.size())), moved.back());
    }
    LeafSequence::Moves moves;
    for (const ObjectId leaf : moved) {
      const auto at = std::find(order.begin(), order.end(), leaf);
      moves.emplace_back(leaf, at == order.begin() ? kNoObject : *(at - 1));
    }
    sequence.apply(moves);
    expect_order(sequence, order);
  }
}

}  // namespace leaf_sequence_test
}  // namespace kinex::test
