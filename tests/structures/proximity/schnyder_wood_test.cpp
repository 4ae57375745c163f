// SPDX-License-Identifier: GPL-3.0-or-later
// The swap rule of Schnyder woods: random swaps of neighbours in any three orders in which no two
// points are ordered alike, against the definition.
#include "structures/proximity/schnyder_wood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace schnyder_wood_test {

using Ids = std::vector<ObjectId>;

struct Orders {
  std::array<Ids, 3> points, place;

  bool before(std::size_t order, ObjectId a, ObjectId b) const {
    return place[order][a] < place[order][b];
  }
  void number(std::size_t order, std::size_t n) {
    place[order].assign(n, 0);
    for (ObjectId i = 0; i < points[order].size(); ++i) place[order][points[order][i]] = i;
  }
  ObjectId next(std::size_t colour, ObjectId p) const {
    const std::size_t j = (colour + 1) % 3, k = (colour + 2) % 3;
    for (const ObjectId q : points[colour]) {
      if (q != p && before(j, q, p) && before(k, q, p)) return q;
    }
    return kNoObject;
  }
};

struct Woods {
  // Some of n points, the third order being the reverse of the first.
  Woods(std::uint64_t seed, std::size_t n, std::size_t left_out)
      : random(seed),
        wood(
            n,
            [this](std::size_t order, ObjectId a, ObjectId b) {
              return orders.before(order, a, b);
            },
            [this](std::size_t colour, ObjectId p, ObjectId old) {
              EXPECT_EQ(known[colour][p], old);
              known[colour][p] = wood.next(colour, p);
              ++changes;
            }) {
    for (auto& pointers : known) pointers.assign(n, kNoObject);
    Ids ids(n);
    std::iota(ids.begin(), ids.end(), 0);
    for (std::size_t i = 0; i < left_out; ++i) ids.erase(ids.begin() + pick(ids.size()));
    for (const std::size_t order : {0, 1}) {
      for (std::size_t i = ids.size(); i > 1; --i) std::swap(ids[i - 1], ids[at(i)]);
      orders.points[order] = ids;
    }
    orders.points[2].assign(orders.points[0].rbegin(), orders.points[0].rend());
    for (std::size_t order = 0; order < 3; ++order) orders.number(order, n);
    make();
  }
  std::size_t at(std::size_t below) {
    return static_cast<std::size_t>(random.between(0, static_cast<int>(below) - 1));
  }
  std::ptrdiff_t pick(std::size_t below) { return static_cast<std::ptrdiff_t>(at(below)); }
  void make() {
    wood.make({std::span<const ObjectId>(orders.points[0]), orders.points[1], orders.points[2]});
  }
  // Two neighbours of a random order, if they may change places.
  bool swap() {
    const std::size_t order = at(3);
    Ids& points = orders.points[order];
    const std::size_t i = at(points.size() - 1);
    const ObjectId q = points[i], p = points[i + 1];
    std::swap(orders.place[order][q], orders.place[order][p]);
    const std::uint64_t before = changes;
    const auto swapped = wood.swap(order, q, p);
    EXPECT_EQ(swapped == SchnyderWood::Swap::kDone, changes != before);
    if (swapped == SchnyderWood::Swap::kImpossible) {
      std::swap(orders.place[order][q], orders.place[order][p]);
      return false;
    }
    std::swap(points[i], points[i + 1]);
    return true;
  }
  void expect_right(std::size_t n) {
    AuditReport report;
    wood.check(report);
    EXPECT_EQ(report.violations, std::vector<std::string>{});
    for (std::size_t colour = 0; colour < 3; ++colour) {
      for (const ObjectId p : orders.points[0]) {
        ASSERT_EQ(wood.next(colour, p), orders.next(colour, p)) << "colour " << colour;
      }
      for (ObjectId p = 0; p < n; ++p) ASSERT_EQ(known[colour][p], wood.next(colour, p));
    }
  }

  Random random;
  Orders orders;
  std::array<Ids, 3> known;
  std::uint64_t changes = 0;
  SchnyderWood wood;
};

TEST(SchnyderWood, RandomSwaps) {
  std::uint64_t swaps = 0, changes = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(40u); ++seed) {
    SCOPED_TRACE(seed);
    const std::size_t n = 3 + seed % 12;
    Woods woods(seed, n, seed % 2);
    woods.expect_right(n);
    woods.changes = 0;
    for (int step = 0; step < 150; ++step) {
      if (!woods.swap()) continue;
      ++swaps;
      woods.expect_right(n);
      if (HasFailure()) return;
    }
    changes += woods.changes;
    woods.make();  // as it is
    woods.expect_right(n);
  }
  EXPECT_GT(swaps, test::seen_in_fewer(2000u));
  EXPECT_GT(changes, test::seen_in_fewer(2000u));
}

TEST(SchnyderWood, FewPoints) {
  SchnyderWood wood(
      2, [](std::size_t order, ObjectId a, ObjectId b) { return order == 2 ? b < a : a < b; },
      [](std::size_t, ObjectId, ObjectId) {});
  wood.make({});
  EXPECT_EQ(wood.next(0, 0), kNoObject);
  const Ids up{0, 1}, down{1, 0};
  wood.make({std::span<const ObjectId>(up), up, down});
  // Only colour 2, whose other orders are those that agree, has a point in front of 1.
  EXPECT_EQ(wood.next(2, 1), 0u);
  EXPECT_EQ(wood.next(0, 1), kNoObject);
  EXPECT_EQ(wood.next(1, 1), kNoObject);
  EXPECT_EQ(wood.next(0, 0), kNoObject);
}

}  // namespace schnyder_wood_test
}  // namespace kinex::test
