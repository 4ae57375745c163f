// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates on edges, strips and rectangles: known signs and the numbered identities; predicates
// that take an object for several arguments.
#include "predicates/points/edge_predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "predicates/points/shared_arguments.h"

namespace kinex {
namespace edge_predicates_test {

struct Place {
  int x, y;
};

// The value at points at rest.
Integer value(const Predicate& p, const std::vector<Place>& places) {
  std::vector<std::vector<Integer>> motions;
  for (const Place& place : places) motions.push_back({Integer(place.x), Integer(0), Integer(place.y), Integer(0)});
  std::vector<MotionView<Integer>> views;
  for (const auto& motion : motions) views.push_back(motion.data());
  const Polynomial result = p.exact(1, views.data());
  return result.is_zero() ? Integer(0) : result[0];
}

std::vector<Place> random_places(std::mt19937_64& random, std::size_t n) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < n; ++i) {
    places.push_back({static_cast<int>(random() % 41) - 20, static_cast<int>(random() % 41) - 20});
  }
  return places;
}

TEST(EdgePredicates, KnownSigns) {
  const auto dot = make_edge_dot_2(), strip = make_strip_order_2();
  const auto area = make_rectangle_area_order_2(), perimeter = make_rectangle_perimeter_order_2();
  EXPECT_EQ(value(*dot, {{0, 0}, {2, 0}, {5, 5}, {8, 9}}), Integer(6));
  EXPECT_EQ(value(*dot, {{0, 0}, {0, 1}, {5, 5}, {9, 5}}), Integer(0));
  // Widths 3 and 4, of edges of lengths 2 and 1: 16 * 4 - 36 * 1.
  EXPECT_EQ(value(*strip, {{0, 0}, {2, 0}, {9, 3}, {5, 0}, {6, 0}, {0, 4}}), Integer(28));
  EXPECT_EQ(value(*strip, {{0, 0}, {2, 0}, {9, 3}, {5, 0}, {5, 1}, {2, 7}}), Integer(0));
  // Rectangles of 6 by 2 and 4 by 3, equal in area.
  const std::vector<Place> flat{{0, 0}, {6, 0}, {6, 2}, {3, 2}, {0, 1}};
  const std::vector<Place> high{{1, 1}, {2, 1}, {4, 2}, {3, 4}, {0, 2}};
  std::vector<Place> both = flat;
  both.insert(both.end(), high.begin(), high.end());
  EXPECT_EQ(value(*area, both), Integer(0));
  EXPECT_TRUE(value(*perimeter, both).sign() < 0);  // 8 against 7
}

TEST(EdgePredicates, Identities) {
  std::mt19937_64 random(5);
  const auto dot = make_edge_dot_2(), strip = make_strip_order_2();
  for (int round = 0; round < 100; ++round) {
    const std::vector<Place> p = random_places(random, 10);
    const Place a = p[0], b = p[1], c = p[2], d = p[3], e = p[4], f = p[5];
    EXPECT_EQ(value(*dot, {b, a, c, d}), -value(*dot, {a, b, c, d}));  // (1)
    EXPECT_EQ(value(*dot, {a, b, d, c}), -value(*dot, {a, b, c, d}));
    EXPECT_EQ(value(*dot, {c, d, a, b}), value(*dot, {a, b, c, d}));   // (2)
    EXPECT_GE(value(*dot, {a, b, a, b}).sign(), 0);                    // (3)
    const auto moved = [](Place q) { return Place{q.x + 7, q.y - 3}; };
    EXPECT_EQ(value(*dot, {a, b, moved(c), moved(d)}), value(*dot, {a, b, c, d}));  // (4)
    const Integer narrower = value(*strip, {a, b, c, d, e, f});
    EXPECT_EQ(value(*strip, {d, e, f, a, b, c}), -narrower);                               // (1)
    EXPECT_EQ(value(*strip, {b, a, c, d, e, f}), narrower);                                // (2)
    EXPECT_GE(value(*strip, {a, b, a, d, e, f}).sign(), 0);                                // (3)
    EXPECT_EQ(value(*strip, {a, b, c, moved(d), moved(e), moved(f)}), narrower);           // (4)
    for (const auto& order : {make_rectangle_area_order_2(), make_rectangle_perimeter_order_2()}) {
      std::vector<Place> exchanged = p, translated = p;
      std::rotate(exchanged.begin(), exchanged.begin() + 5, exchanged.end());
      EXPECT_EQ(value(*order, exchanged), -value(*order, p));  // (1)
      for (std::size_t i = 0; i < 5; ++i) translated[i] = moved(p[i]);
      EXPECT_EQ(value(*order, translated), value(*order, p));  // (2)
    }
  }
}

TEST(SharedArguments, IsTheWholeOfTheObjects) {
  std::mt19937_64 random(6);
  const auto strip = make_strip_order_2();
  const std::vector<std::uint8_t> pattern{0, 1, 2, 1, 2, 3}, exchanged{1, 2, 3, 0, 1, 2};
  const auto shared = make_shared_arguments(strip, pattern);
  const auto opposite = make_shared_arguments(strip, exchanged);
  EXPECT_EQ(shared->name(), "order_strip/012123");
  EXPECT_EQ(shared->arity(), 4);
  EXPECT_EQ(shared->degree(3), 18);
  EXPECT_EQ(shared->opposite(), opposite->name());
  EXPECT_EQ(opposite->opposite(), shared->name());
  EXPECT_EQ(shared->form().roles.size(), 4u);
  EXPECT_EQ(shared->form().figure, ClaimFigure::kStrips);
  EXPECT_EQ(std::vector<std::uint8_t>(shared->form().places.begin(), shared->form().places.end()),
            pattern);
  EXPECT_EQ(shared->form().says,
            "{2} is no farther from the line through {0} and {1} than {3} is from that through "
            "{1} and {2}");
  for (int round = 0; round < 50; ++round) {
    const std::vector<Place> p = random_places(random, 4);
    const Integer whole = value(*strip, {p[0], p[1], p[2], p[1], p[2], p[3]});
    EXPECT_EQ(value(*shared, p), whole);     // (1)
    EXPECT_EQ(value(*opposite, p), -whole);  // (2)
  }
}

TEST(SharedArguments, RefusesPatternsThatLeaveOut) {
  const auto dot = make_edge_dot_2();
  for (const std::vector<std::uint8_t>& wrong :
       {std::vector<std::uint8_t>{0, 1, 1}, {0, 1, 3, 2, 2}, {0, 1, 1, 3}, {1, 2, 2, 3}, {}}) {
    EXPECT_THROW(make_shared_arguments(dot, wrong), std::invalid_argument);
  }
}

}  // namespace edge_predicates_test
}  // namespace kinex
