// SPDX-License-Identifier: GPL-3.0-or-later
// Lattices that are sheared through the square or cubic one, and a bipyramid that passes a sphere: many
// points on a circle, or on a sphere, at one instant, and no other events than at such instants.
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/triangulation/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

// The first n points of the lattice {0, .., side - 1}^d in lexicographic order, for the smallest side that
// has n: the last coordinate changes first. `velocity` of a place (x, y, z), with z = 0 in the plane.
template <class Velocity>
void add_lattice(const lab::WorkloadParameters& parameters, Scene& scene,
                 const Velocity& velocity) {
  const int axes = parameters.dimension;
  std::int64_t side = 1;
  const auto points = [&] { return axes == 3 ? side * side * side : side * side; };
  while (points() < parameters.n) ++side;
  for (std::int64_t i = 0; i < parameters.n; ++i) {
    std::array<std::int64_t, 3> place{0, 0, 0};
    std::int64_t rank = i;
    for (int axis = axes; axis-- > 0; rank /= side)
      place[static_cast<std::size_t>(axis)] = rank % side;
    const std::array<std::int64_t, 3> speed = velocity(place);
    std::vector<std::vector<Rational>> line;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis) {
      line.push_back({Rational(place[axis]), Rational(speed[axis])});
    }
    lab::add_object(scene, "p" + std::to_string(i), std::move(line));
  }
}

}  // namespace

// Velocities (y, 0, 0), -2 <= t <= 2: at every integer t the lattice is the square (cubic) one again, and all
// its cells change. Of {0, 1, 2}^2 four cells at t = -1, eight at 0, four at 1; of {0, 1}^3 six at 0.
void generate_sheared_lattice(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = -2;
  scene.end = Rational(2);
  add_lattice(parameters, scene, [](const std::array<std::int64_t, 3>& at) {
    return std::array<std::int64_t, 3>{at[1], 0, 0};
  });
}

// In space, velocities (y + z, z, 0), -1 <= t <= 1.
void generate_twice_sheared_lattice(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = -1;
  scene.end = Rational(1);
  add_lattice(parameters, scene, [](const std::array<std::int64_t, 3>& at) {
    return std::array<std::int64_t, 3>{at[1] + at[2], at[2], 0};
  });
}

// n points of the unit circle in the plane z = 0, (0, 0, 1 + t) and (0, 0, -1), -1/2 <= t <= 1/2: of 4 the
// octahedron. All are on the unit sphere at t = 0, where n cells about the axis become 2(n - 2) on both
// sides of the circle. Rational points: those of one quadrant, turned by right angles.
void generate_bipyramid(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n, quarter = (n + 3) / 4;
  scene.start = lab::fraction(-1, 2);
  scene.end = lab::fraction(1, 2);
  for (std::int64_t i = 0; i < n; ++i) {
    const std::int64_t k = i / 4, square = quarter * quarter + k * k;
    const Rational x = lab::fraction(quarter * quarter - k * k, square);
    const Rational y = lab::fraction(2 * quarter * k, square);
    const std::array<std::array<Rational, 2>, 4> turned{{{x, y}, {-x, -y}, {-y, x}, {y, -x}}};
    const auto& [across, along] = turned[static_cast<std::size_t>(i % 4)];
    lab::add_object(scene, "c" + std::to_string(i), {{across}, {along}, {Rational(0)}});
  }
  lab::add_object(scene, "above", {{Rational(0)}, {Rational(0)}, {Rational(1), Rational(1)}});
  lab::add_object(scene, "below", {{Rational(0)}, {Rational(0)}, {Rational(-1)}});
}

}  // namespace kinex::families
