// SPDX-License-Identifier: GPL-3.0-or-later
// Random linear motions that are degenerate, or nearly so, at t = 1/2, in t in [0, 1].
#include "experiments/families/points/workloads.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

// A near miss is at most 2^10 times 2^-70.
constexpr std::int64_t kMissUnits = 1 << 10;
constexpr unsigned long kMissExponent = 70;

// At `half` (in grid units) at t = 1/2, with a random velocity in [-1, 1] on every axis. `misses`:
// a random near miss is added on every axis.
void add_passing(Scene& scene, int i, const std::vector<std::int64_t>& half, lab::WorkloadRandom& random,
                 bool misses = false) {
  std::vector<std::vector<Rational>> coordinates;
  for (const std::int64_t x : half) {
    const std::int64_t velocity = random.between(-lab::kGridUnits, lab::kGridUnits);
    Rational start = lab::fraction(2 * x - velocity, 2 * lab::kGridUnits);
    if (misses) {
      start += Rational(Integer(random.between(-kMissUnits, kMissUnits)),
                        Integer::power_of_two(kMissExponent));
    }
    coordinates.push_back({std::move(start), lab::on_grid(velocity)});
  }
  lab::add_object(scene, "p" + std::to_string(i), std::move(coordinates));
}

void set_time(Scene& scene) {
  scene.start = 0;
  scene.end = 1;
}

}  // namespace

// Objects 2k and 2k+1 are at one random place at t = 1/2.
void generate_meet(const lab::WorkloadParameters& parameters, Scene& scene) {
  set_time(scene);
  lab::WorkloadRandom random(parameters.seed);
  std::vector<std::int64_t> place(static_cast<std::size_t>(scene.dimension));
  for (int i = 0; i < parameters.n; ++i) {
    if (i % 2 == 0) {
      for (std::int64_t& x : place) x = random.between(0, lab::kGridUnits);
    }
    add_passing(scene, i, place, random);
  }
}

// All objects are in the middle of the unit square at t = 1/2.
void generate_through_one_point(const lab::WorkloadParameters& parameters, Scene& scene) {
  set_time(scene);
  lab::WorkloadRandom random(parameters.seed);
  const std::vector<std::int64_t> place(static_cast<std::size_t>(scene.dimension), lab::kGridUnits / 2);
  for (int i = 0; i < parameters.n; ++i) add_passing(scene, i, place, random);
}

// All objects are within 2^-60 of the middle of the unit square, on each axis, at t = 1/2.
void generate_near_one_point(const lab::WorkloadParameters& parameters, Scene& scene) {
  set_time(scene);
  lab::WorkloadRandom random(parameters.seed);
  const std::vector<std::int64_t> place(static_cast<std::size_t>(scene.dimension), lab::kGridUnits / 2);
  for (int i = 0; i < parameters.n; ++i) add_passing(scene, i, place, random, true);
}

// All objects are on the line y = x/2 at t = 1/2.
void generate_collinear_instant(const lab::WorkloadParameters& parameters, Scene& scene) {
  set_time(scene);
  lab::WorkloadRandom random(parameters.seed);
  for (int i = 0; i < parameters.n; ++i) {
    const std::int64_t y = random.between(0, lab::kGridUnits / 2);
    add_passing(scene, i, {2 * y, y}, random);
  }
}

}  // namespace kinex::families
