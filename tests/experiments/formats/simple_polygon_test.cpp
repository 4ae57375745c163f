// SPDX-License-Identifier: GPL-3.0-or-later
// Edges of a polygon that meet, against all pairs of segments in small integers.
#include "experiments/formats/simple_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace kinex {
namespace simple_polygon_test {

using Point = std::array<int, 2>;

std::vector<Vertex2> polygon_of(const std::vector<Point>& points) {
  std::vector<Vertex2> polygon;
  for (const Point& p : points) polygon.push_back({Rational(p[0]), Rational(p[1])});
  return polygon;
}

// Common points are p + s d = q + u e with s and u in [0, 1]; parallel segments are compared along
// their line.
bool meet(const Point& p, const Point& to_p, const Point& q, const Point& to_q) {
  const Point d{to_p[0] - p[0], to_p[1] - p[1]}, e{to_q[0] - q[0], to_q[1] - q[1]};
  const Point w{q[0] - p[0], q[1] - p[1]};
  const auto cross = [](const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; };
  const auto dot = [](const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; };
  int below = cross(d, e), s = cross(w, e), u = cross(w, d);
  if (below == 0) {
    if (u != 0) return false;
    const int from = dot(w, d), to = from + dot(e, d), size = dot(d, d);
    return std::max(from, to) >= 0 && std::min(from, to) <= size;
  }
  if (below < 0) {
    below = -below;
    s = -s;
    u = -u;
  }
  return 0 <= s && s <= below && 0 <= u && u <= below;
}

TEST(SimplePolygon, AgainstAllPairs) {
  std::mt19937_64 engine(7);
  int simple = 0, crossed = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::size_t n = 3 + engine() % 6;
    std::vector<Point> points;
    while (points.size() < n) {
      const Point p{static_cast<int>(engine() % 8), static_cast<int>(engine() % 8)};
      if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
    }
    const auto pair_meets = [&](std::size_t e, std::size_t f) {
      return meet(points[e], points[(e + 1) % n], points[f], points[(f + 1) % n]);
    };
    bool any = false;
    for (std::size_t e = 0; e < n; ++e) {
      for (std::size_t f = e + 2; f < n; ++f) {
        if (f - e < n - 1) any = any || pair_meets(e, f);
      }
    }
    const auto found = formats::edges_that_meet(polygon_of(points));
    ASSERT_EQ(found.has_value(), any);
    ++(any ? crossed : simple);
    if (!found) continue;
    const auto [e, f] = *found;
    EXPECT_TRUE(e + 1 < f && f - e < n - 1 && f < n);
    EXPECT_TRUE(pair_meets(e, f)) << e << " " << f;
  }
  EXPECT_GT(simple, 500);
  EXPECT_GT(crossed, 500);
}

// Long edges that all overlap in x: it gives up at its limit.
TEST(SimplePolygon, GivesUpOnMany) {
  std::vector<Point> points;
  for (int i = 0; i < 6000; ++i) points.push_back({i % 2 == 0 ? 0 : 1000000, i});
  EXPECT_EQ(formats::edges_that_meet(polygon_of(points)), std::nullopt);
}

}  // namespace simple_polygon_test
}  // namespace kinex
