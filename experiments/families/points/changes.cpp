// SPDX-License-Identifier: GPL-3.0-or-later
// Random motion whose flight plans change, and random motion of objects that appear and disappear:
// the cost of an update, an insertion and an erasure.
#include <algorithm>
#include <cstddef>
#include <optional>

#include "experiments/families/points/workloads.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

// Instants are multiples of 2^-40: two of one family hardly ever coincide, and may.
constexpr std::int64_t kInstants = std::int64_t{1} << 40;

Rational instant(lab::WorkloadRandom& random, std::int64_t low, std::int64_t high) {
  return Rational(Integer(random.between(low, high)), Integer(kInstants));
}

std::vector<Rational> random_place(lab::WorkloadRandom& random, int dimension) {
  std::vector<Rational> place;
  for (int axis = 0; axis < dimension; ++axis) {
    place.push_back(lab::on_grid(random.between(0, lab::kGridUnits)));
  }
  return place;
}

// From `place` at time `from` to `destination` one unit of time later.
Trajectory heading(const std::vector<Rational>& place, const std::vector<Rational>& destination,
                   const Rational& from) {
  Trajectory trajectory;
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    const Rational speed = destination[axis] - place[axis];
    trajectory.coordinates.push_back({place[axis] - speed * from, speed});
  }
  trajectory.normalise();
  return trajectory;
}

}  // namespace

void generate_new_plans(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = 1;
  std::vector<std::vector<Rational>> changes(static_cast<std::size_t>(parameters.n));
  for (int k = 0; k < parameters.m; ++k) {
    std::vector<Rational>& own = changes[random.below(changes.size())];
    own.push_back(instant(random, 1, kInstants - 1));
  }
  for (std::size_t i = 0; i < changes.size(); ++i) {
    std::vector<Rational>& own = changes[i];
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    const std::vector<Rational> origin = random_place(random, scene.dimension);
    Motion motion;
    motion.pieces.push_back({std::nullopt, std::nullopt,
                             heading(origin, random_place(random, scene.dimension), scene.start)});
    for (const Rational& when : own) {
      MotionPiece& before = motion.pieces.back();
      before.to = when;
      std::vector<Rational> place;
      for (int axis = 0; axis < scene.dimension; ++axis) {
        place.push_back(before.trajectory.position(axis, when));
      }
      motion.pieces.push_back(
          {when, std::nullopt, heading(place, random_place(random, scene.dimension), when)});
    }
    scene.objects.push_back({"p" + std::to_string(i), std::move(motion)});
  }
}

void generate_come_and_go(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = 1;
  for (int i = 0; i < parameters.n; ++i) {
    const std::vector<Rational> origin = random_place(random, scene.dimension);
    MotionPiece piece{std::nullopt, std::nullopt,
                      heading(origin, random_place(random, scene.dimension), scene.start)};
    if (i % 2 == 1) piece.from = instant(random, 1, kInstants / 2);
    if (i % 4 >= 2) piece.to = instant(random, kInstants / 2 + 1, kInstants - 1);
    Motion motion;
    motion.pieces.push_back(std::move(piece));
    scene.objects.push_back({"p" + std::to_string(i), std::move(motion)});
  }
}

}  // namespace kinex::families
