// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/proximity/hub_scenes.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

struct Direction {
  Rational x, y;
};

// The i-th of n unit vectors counter-clockwise. u = tan(angle / 2) grows evenly from 0 to 1 in the
// first quadrant, and the angle at least as fast: neighbours are at least 4 / n radians apart.
Direction direction(std::int64_t i, std::int64_t n) {
  const std::int64_t quadrant = 4 * i / n;
  const Rational u = lab::fraction(4 * i - quadrant * n, n);
  const Rational scale = Rational(1) + u * u;
  Rational x = (Rational(1) - u * u) / scale, y = Rational(2) * u / scale;
  for (std::int64_t turn = 0; turn < quadrant; ++turn) {
    Rational next = -y;
    y = std::move(x);
    x = std::move(next);
  }
  return {x, y};
}

// Numbers from 0 to 7 that differ from one neighbour to the next.
std::int64_t jitter(std::int64_t i, std::int64_t step) { return i * step % 8; }

}  // namespace

Scene hub_of_points(int n) {
  Scene scene;
  scene.dimension = 2;
  scene.start = 0;
  scene.end = Rational(1);
  lab::add_object(scene, "hub", {{Rational(0)}, {Rational(0)}});
  const std::int64_t ring = std::int64_t{n} - 1;
  // Neighbours differ by less than 1 / ring in their distances from the hub, and are 4 / ring apart:
  // from each, the other is far from the direction of the hub.
  for (std::int64_t i = 0; i < ring; ++i) {
    const Direction to = direction(i, ring);
    const Rational first = Rational(1) + lab::fraction(jitter(i, 5), 16 * ring);
    const Rational growth = lab::fraction(jitter(i, 3), 16 * ring);
    lab::add_object(scene, "p" + std::to_string(i),
                    {{first * to.x, growth * to.x}, {first * to.y, growth * to.y}});
  }
  return scene;
}

Scene hub_of_discs(int n) {
  Scene scene;
  scene.dimension = 2;
  scene.start = 0;
  scene.end = Rational(1);
  scene.extents = Extents::kRadius;
  lab::add_object(scene, "hub", {{Rational(0)}, {Rational(0)}, {Rational(1)}});
  const std::int64_t ring = std::int64_t{n} - 1;
  // In these units the radii are 4, gaps to the large disc from 1 to 15, and those of neighbours, whose
  // centres are nearly 256 apart, above 200.
  const std::int64_t units = 64 * ring;  // in 1
  for (std::int64_t i = 0; i < ring; ++i) {
    const Direction to = direction(i, ring);
    const Rational first = Rational(1) + lab::fraction(4 + 1 + jitter(i, 5), units);
    const Rational growth = lab::fraction(jitter(i, 3), units);
    lab::add_object(
        scene, "p" + std::to_string(i),
        {{first * to.x, growth * to.x}, {first * to.y, growth * to.y}, {lab::fraction(4, units)}});
  }
  return scene;
}

}  // namespace kinex::families
