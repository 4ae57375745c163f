// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies for tests.
#ifndef KINEX_TESTS_EXPERIMENTS_BODY_FIXTURE_H
#define KINEX_TESTS_EXPERIMENTS_BODY_FIXTURE_H

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/formats/placed_body.h"

namespace kinex {

inline Rational ratio(int p, int q) { return Rational(Integer(p), Integer(q)); }

inline Trajectory trajectory(std::vector<std::vector<Rational>> coordinates) {
  Trajectory result{std::move(coordinates)};
  result.normalise();
  return result;
}

// A body with one flight plan: x, y, p, q.
inline SceneObject body(std::string id, formats::Polygon2 polygon,
                        std::vector<std::vector<Rational>> coordinates) {
  Motion motion;
  motion.pieces.push_back({std::nullopt, std::nullopt, trajectory(std::move(coordinates))});
  return {std::move(id), std::move(motion), std::move(polygon)};
}

inline formats::Polygon2 square_of(int half) {
  return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
}

inline formats::Polygon2 box(int x_low, int y_low, int x_high, int y_high) {
  return {{x_low, y_low}, {x_high, y_low}, {x_high, y_high}, {x_low, y_high}};
}

// The strict hull of `points` points of the integer grid in [-size, size]^2, at least a triangle.
inline formats::Polygon2 random_polygon(std::mt19937_64& random, int points, int size) {
  const auto draw = [&] {
    return Rational(static_cast<int>(random() % static_cast<unsigned>(2 * size + 1)) - size);
  };
  const auto left = [](const Vertex2& a, const Vertex2& b, const Vertex2& c) {
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign() > 0;
  };
  for (;;) {
    std::vector<Vertex2> set;
    for (int i = 0; i < points; ++i) set.push_back({draw(), draw()});
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
    formats::Polygon2 hull;
    for (int pass = 0; pass < 2; ++pass) {
      const std::size_t floor = hull.size();
      for (const Vertex2& v : set) {
        while (hull.size() >= floor + 2 && !left(hull[hull.size() - 2], hull.back(), v)) {
          hull.pop_back();
        }
        hull.push_back(v);
      }
      hull.pop_back();
      std::reverse(set.begin(), set.end());
    }
    if (hull.size() >= 3) return hull;
  }
}

}  // namespace kinex

#endif
