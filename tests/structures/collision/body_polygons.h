// SPDX-License-Identifier: GPL-3.0-or-later
// Convex polygons for the tests of structures for bodies: regular, random, thin, with a sharp
// corner, with edges along the axes, huge and tiny ones.
#ifndef KINEX_TESTS_STRUCTURES_COLLISION_BODY_POLYGONS_H
#define KINEX_TESTS_STRUCTURES_COLLISION_BODY_POLYGONS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/scene.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {

using Polygon = std::vector<Vertex2>;

inline Rational over(int p, int q) { return Rational(Integer(p), Integer(q)); }

// The point of the unit circle at half the angle of `u`'s tangent.
inline Vertex2 on_circle(const Rational& u) {
  const Rational square = u * u, n = Rational(1) + square;
  return {(Rational(1) - square) / n, Rational(2) * u / n};
}

// Nearly regular: vertices on the unit circle, the first at the angle `offset` of a step.
inline Polygon regular(int n, double offset = 0) {
  Polygon polygon;
  for (int k = 0; k < n; ++k) {
    double angle = 2 * 3.14159265358979323846 * (k + offset) / n;
    int quarters = 0;
    for (; angle >= 1.5707963267948966; angle -= 1.5707963267948966) ++quarters;
    const int u = static_cast<int>(std::lround(std::tan(angle / 2) * (1 << 24)));
    Vertex2 v = on_circle(over(u, 1 << 24));
    for (int i = 0; i < quarters; ++i) v = {-v[1], v[0]};
    polygon.push_back(std::move(v));
  }
  return polygon;
}

inline Polygon scaled(Polygon polygon, const Rational& x, const Rational& y) {
  for (Vertex2& v : polygon) v = {v[0] * x, v[1] * y};
  return polygon;
}

inline Polygon shifted(Polygon polygon, const Rational& x, const Rational& y) {
  for (Vertex2& v : polygon) v = {v[0] + x, v[1] + y};
  return polygon;
}

// Turned by the rotor p + iq.
inline Polygon turned(Polygon polygon, const Rational& p, const Rational& q) {
  const Rational n = p * p + q * q, c = (p * p - q * q) / n, s = Rational(2) * p * q / n;
  for (Vertex2& v : polygon) v = {c * v[0] - s * v[1], s * v[0] + c * v[1]};
  return polygon;
}

// The same polygon, listed from another vertex on.
inline Polygon from_vertex(Polygon polygon, std::size_t first) {
  const auto middle = polygon.begin() + static_cast<std::ptrdiff_t>(first % polygon.size());
  std::rotate(polygon.begin(), middle, polygon.end());
  return polygon;
}

inline Polygon rectangle(const Rational& x, const Rational& y) {
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

// On the parabola y = x^2 at x = 1, 1/2, 1/4, .. and closed by its chord: n vertices.
inline Polygon geometric_chain(int n) {
  Polygon polygon;
  Rational x(1);
  for (int k = 0; k < n; ++k, x /= Rational(2)) polygon.push_back({x, x * x});
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

// The strict hull of random points of a grid.
inline Polygon random_hull(Random& random, int points, int size) {
  const auto turn = [](const Vertex2& a, const Vertex2& b, const Vertex2& c) {
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign();
  };
  for (;;) {
    std::vector<Vertex2> set;
    for (int i = 0; i < points; ++i) {
      set.push_back({random.between(-size, size), random.between(-size, size)});
    }
    std::sort(set.begin(), set.end());
    Polygon hull;
    for (int pass = 0; pass < 2; ++pass) {
      const std::size_t floor = hull.size();
      for (const Vertex2& v : set) {
        while (hull.size() >= floor + 2 && turn(hull[hull.size() - 2], hull.back(), v) <= 0) {
          hull.pop_back();
        }
        if (hull.size() == floor || hull.back() != v) hull.push_back(v);
      }
      hull.pop_back();
      std::reverse(set.begin(), set.end());
    }
    if (hull.size() >= 3) return hull;
  }
}

struct NamedPolygon {
  std::string name;
  Polygon polygon;
};

// One or more of every kind. `n`: vertices of the larger ones.
inline std::vector<NamedPolygon> polygon_zoo(int n) {
  Random random(7);
  std::vector<NamedPolygon> zoo{
      {"triangle", {{0, 0}, {5, 1}, {2, 7}}},
      {"right triangle", {{0, 0}, {3, 0}, {0, 4}}},
      {"needle", {{0, 0}, {1000000, 1}, {999999, 2}}},
      {"square", rectangle(1, 1)},
      {"thin box", rectangle(1000000, over(1, 1000000))},
      {"diamond", {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}},
      {"octagon with edges along the axes",
       {{2, -1}, {2, 1}, {1, 2}, {-1, 2}, {-2, 1}, {-2, -1}, {-1, -2}, {1, -2}}},
      {"one edge along an axis", {{-3, 0}, {4, 0}, {5, 2}, {1, 9}, {-4, 3}}},
      {"regular", regular(n)},
      {"regular, turned", regular(n, 0.5)},
      {"regular, odd", regular(n - 1, 0.3)},
      {"thin", scaled(regular(n, 0.2), 1, over(1, 1000000000))},
      {"thin and turned", turned(scaled(regular(n, 0.2), 1, over(1, 100000)), 3, 1)},
      {"geometric chain", geometric_chain(n)},
      {"huge", scaled(regular(n / 2, 0.1), *Rational::parse("1e30"), *Rational::parse("1e30"))},
      {"tiny", scaled(regular(n / 2, 0.1), *Rational::parse("1e-30"), *Rational::parse("1e-30"))},
      {"far away", shifted(regular(n / 2), *Rational::parse("1e20"), *Rational::parse("-1e19"))},
  };
  for (int i = 0; i < 12; ++i) {
    zoo.push_back({"random " + std::to_string(i), random_hull(random, 4 + 4 * i, 3 + i * i * 10)});
  }
  return zoo;
}

// A body with one flight plan: x, y, p, q.
inline SceneObject rigid(std::string id, Polygon polygon,
                         std::vector<std::vector<Rational>> coordinates) {
  SceneObject object = moving(std::move(id), path(std::move(coordinates)));
  object.polygon = std::move(polygon);
  return object;
}

}  // namespace kinex::test

#endif
