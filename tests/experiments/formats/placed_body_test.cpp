// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/placed_body.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/experiments/body_fixture.h"

namespace kinex {
namespace placed_body_test {

// ---- another way: two convex polygons are apart iff no vertex lies in the other and no edges meet

int side(const Vertex2& a, const Vertex2& b, const Vertex2& c) {
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign();
}

bool contains(const formats::Polygon2& p, const Vertex2& v) {
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (side(p[k], p[(k + 1) % p.size()], v) < 0) return false;
  }
  return true;
}

bool within_box(const Vertex2& a, const Vertex2& b, const Vertex2& v) {
  for (std::size_t axis : {0u, 1u}) {
    if (v[axis] < std::min(a[axis], b[axis]) || v[axis] > std::max(a[axis], b[axis])) return false;
  }
  return true;
}

bool segments_meet(const Vertex2& a, const Vertex2& b, const Vertex2& c, const Vertex2& d) {
  const int s1 = side(a, b, c), s2 = side(a, b, d), s3 = side(c, d, a), s4 = side(c, d, b);
  if (s1 * s2 < 0 && s3 * s4 < 0) return true;
  return (s1 == 0 && within_box(a, b, c)) || (s2 == 0 && within_box(a, b, d)) ||
         (s3 == 0 && within_box(c, d, a)) || (s4 == 0 && within_box(c, d, b));
}

bool meet(const formats::Polygon2& a, const formats::Polygon2& b) {
  if (contains(a, b[0]) || contains(b, a[0])) return true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (segments_meet(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return true;
    }
  }
  return false;
}

formats::Polygon2 moved(const formats::Polygon2& p, const Rational& x, const Rational& y) {
  formats::Polygon2 result = p;
  for (Vertex2& v : result) v = {v[0] + x, v[1] + y};
  return result;
}

TEST(PlacedBody, TurnsByTwiceTheAngleOfTheRotor) {
  const formats::Polygon2 bar{{2, 0}, {2, 1}, {0, 0}};
  // 1 + i is turned by 45 degrees, and turns by 90.
  const formats::Polygon2 placed = formats::placed_polygon(bar, trajectory({{7}, {0, 1}, {3}, {3}}), 5);
  EXPECT_EQ(placed, (formats::Polygon2{{7, 7}, {6, 7}, {7, 5}}));
  // 2 + i: cos = 3/5, sin = 4/5.
  const formats::Polygon2 other = formats::placed_polygon(bar, trajectory({{0}, {0}, {2}, {0, 1}}), 1);
  EXPECT_EQ(other[0], (Vertex2{ratio(6, 5), ratio(8, 5)}));
  EXPECT_EQ(other[1], (Vertex2{ratio(2, 5), ratio(11, 5)}));
}

TEST(PlacedBody, ContactOfSquares) {
  const formats::Polygon2 square = square_of(1);
  EXPECT_EQ(formats::contact_of(square, moved(square, 2, 0)), formats::Contact::kTouching);
  EXPECT_EQ(formats::contact_of(square, moved(square, 2, 2)), formats::Contact::kTouching);
  EXPECT_EQ(formats::contact_of(square, moved(square, ratio(199, 100), 2)), formats::Contact::kTouching);
  EXPECT_EQ(formats::contact_of(square, moved(square, ratio(199, 100), 1)), formats::Contact::kOverlapping);
  EXPECT_EQ(formats::contact_of(square, square), formats::Contact::kOverlapping);
  EXPECT_EQ(formats::contact_of(square, square_of(9)), formats::Contact::kOverlapping);
  const Rational hair(Integer(1), Integer::power_of_two(200));
  EXPECT_EQ(formats::contact_of(square, moved(square, Rational(2) + hair, 0)), formats::Contact::kApart);
  EXPECT_EQ(formats::contact_of(square, moved(square, Rational(2) - hair, 0)), formats::Contact::kOverlapping);
}

TEST(PlacedBody, SquaredDistance) {
  const formats::Polygon2 square = square_of(1);
  EXPECT_EQ(formats::squared_distance(square, moved(square, 2, 1)), Rational(0));
  EXPECT_EQ(formats::squared_distance(square, moved(square, 3, 1)), Rational(1));
  EXPECT_EQ(formats::squared_distance(square, moved(square, 5, 6)), Rational(25));
  const formats::Polygon2 wedge{{0, 5}, {-5, 0}, {0, -5}};  // its sides are x - y = -5 and x + y = -5
  EXPECT_EQ(formats::squared_distance(wedge, moved(wedge, 6, 0)), Rational(1));
  EXPECT_EQ(formats::squared_distance(wedge, formats::Polygon2{{-4, 5}, {-4, 4}, {-3, 5}}), ratio(9, 2));
}

// Huge and tiny coordinates leave the doubles behind; the answers do not change.
TEST(PlacedBody, BeyondDoubles) {
  for (const char* text : {"1e400", "1e-400", "1e200", "1e-200"}) {
    const Rational unit = *Rational::parse(text);
    formats::Polygon2 square = square_of(1);
    for (Vertex2& v : square) v = {v[0] * unit, v[1] * unit};
    const Rational two = unit * Rational(2);
    EXPECT_EQ(formats::contact_of(square, moved(square, two, two)), formats::Contact::kTouching);
    EXPECT_EQ(formats::contact_of(square, moved(square, two, two * Rational(2))), formats::Contact::kApart);
    EXPECT_EQ(formats::contact_of(square, moved(square, unit, 0)), formats::Contact::kOverlapping);
    EXPECT_EQ(formats::squared_distance(square, moved(square, two * Rational(2), 0)), two * two);
  }
}

TEST(PlacedBody, AgreesWithEdgesOnRandomPolygons) {
  std::mt19937_64 random(7);
  int apart = 0, touching = 0;
  for (int round = 0; round < 600; ++round) {
    const formats::Polygon2 a = random_polygon(random, 9, 6);
    const formats::Polygon2 b = moved(random_polygon(random, 9, 6), static_cast<int>(random() % 9),
                             static_cast<int>(random() % 9));
    const formats::Contact contact = formats::contact_of(a, b);
    EXPECT_EQ(contact, formats::contact_of(b, a));
    EXPECT_EQ(contact != formats::Contact::kApart, meet(a, b));
    EXPECT_EQ(contact == formats::Contact::kApart, formats::squared_distance(a, b).sign() > 0);
    apart += contact == formats::Contact::kApart;
    touching += contact == formats::Contact::kTouching;
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(touching, 5);
  EXPECT_LT(apart, 500);
}

}  // namespace placed_body_test
}  // namespace kinex
