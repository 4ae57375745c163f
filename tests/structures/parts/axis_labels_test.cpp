// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/axis_labels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sanitized.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace axis_labels_test {

// Inserts `object` at this place of the order; returns the number of labels given.
std::size_t insert_at(AxisLabels& labels, std::size_t place, ObjectId object) {
  std::vector<ObjectId> order = labels.in_order();
  const ObjectId previous = place == 0 ? kNoObject : order[place - 1];
  const ObjectId next = place == order.size() ? kNoObject : order[place];
  const auto moves = labels.room_between(previous, object, next);
  order.insert(order.begin() + static_cast<std::ptrdiff_t>(place), object);
  if (moves) {
    labels.apply(*moves);
  } else {
    labels.assign(order, labels.bits() + 1);
  }
  EXPECT_TRUE(labels.consistent());
  EXPECT_EQ(labels.in_order(), order);
  return moves ? moves->size() : order.size();
}

// Cuts in front of, between and behind all objects, and neighbours, against the order.
void expect_cuts(const AxisLabels& labels) {
  const std::vector<ObjectId> order = labels.in_order();
  for (std::size_t k = 0; k <= order.size(); ++k) {
    std::size_t asked = 0;
    const AxisLabels::Cut cut = labels.cut([&](ObjectId object) {
      ++asked;
      return labels.rank(object) < k;
    });
    EXPECT_EQ(cut.count, k);
    EXPECT_EQ(cut.first, k == 0 ? 0 : labels.of(order[k - 1]) + std::size_t{1});
    EXPECT_EQ(cut.end, k == order.size() ? labels.size() : labels.of(order[k]));
    EXPECT_LE(asked, labels.bits() + std::size_t{1});
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = 0; j < order.size(); ++j) {
      EXPECT_EQ(labels.are_neighbours(order[i], order[j]), i + 1 == j);
    }
  }
}

TEST(AxisLabels, Bits) {
  const std::vector<unsigned> expected{0, 0, 1, 2, 2, 3, 3, 3, 3, 4};
  for (std::size_t n = 0; n < expected.size(); ++n) {
    EXPECT_EQ(AxisLabels::bits_for(n), expected[n]) << n;
  }
}

TEST(AxisLabels, SpreadEvenly) {
  AxisLabels labels(4);
  labels.assign({2, 0, 3}, 3);
  EXPECT_EQ(labels.in_order(), (std::vector<ObjectId>{2, 0, 3}));
  EXPECT_EQ(labels.of(2), 0u);
  EXPECT_EQ(labels.of(0), 2u);
  EXPECT_EQ(labels.of(3), 5u);
  EXPECT_FALSE(labels.has(1));
  EXPECT_EQ(labels.rank(3), 2u);
  EXPECT_EQ(labels.of_rank(1), 0u);
  labels.exchange(2, 0);
  EXPECT_EQ(labels.in_order(), (std::vector<ObjectId>{0, 2, 3}));
  EXPECT_TRUE(labels.consistent());
}

TEST(AxisLabels, InsertionsAnywhere) {
  for (std::uint64_t seed = 1; seed <= test::fewer(20u); ++seed) {
    Random random(seed);
    constexpr std::size_t kObjects = 60;
    AxisLabels labels(kObjects);
    for (int step = 0; step < 300; ++step) {
      const auto object = static_cast<ObjectId>(random.between(0, kObjects - 1));
      if (labels.has(object)) {
        labels.erase(object);
        EXPECT_TRUE(labels.consistent());
      } else {
        const int places = static_cast<int>(labels.count());
        insert_at(labels, static_cast<std::size_t>(random.between(0, places)), object);
      }
      if (step % 10 == 0) expect_cuts(labels);
    }
  }
}

TEST(AxisLabels, CutsInWideGaps) {
  AxisLabels labels(64);
  std::vector<ObjectId> order;
  for (ObjectId object = 0; object < 64; ++object) order.push_back(object);
  for (const unsigned bits : {6u, 7u}) {
    labels.assign(order, bits);
    for (ObjectId object = 0; object < 64; ++object) {
      if (object % 21 != 5) labels.erase(object);
    }
    EXPECT_EQ(labels.count(), 3u);
    expect_cuts(labels);
  }
  labels.assign({}, 0);
  expect_cuts(labels);
  labels.assign({7}, 0);
  expect_cuts(labels);
}

// At one end, the worst place: amortised O(log^2 n) moves.
TEST(AxisLabels, InsertionsInFrontAreCheap) {
  for (const std::size_t n : {64u, 512u}) {
    AxisLabels labels(n);
    std::size_t moves = 0;
    for (ObjectId object = 0; object < n; ++object) moves += insert_at(labels, 0, object);
    const std::size_t log = AxisLabels::bits_for(n);
    EXPECT_LE(moves, 2 * n * log * log);
    EXPECT_LE(labels.size(), 4 * n);
  }
}

}  // namespace axis_labels_test
}  // namespace kinex::test
