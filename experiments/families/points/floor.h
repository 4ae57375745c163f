// SPDX-License-Identifier: GPL-3.0-or-later
// What the floors have in common. A floor is the least that a program must do to handle the events of
// a kinetic structure (BenchRow::floor).
//
// Plain doubles, no error bounds, no ties, no ledger, no proof, no reports: a failed certificate is
// repaired, and the failure times of the new ones are searched for in the same windows as in kinex.
// The time that a run takes beyond this is the price of everything else. The counts of events must
// agree with those of an exact run; otherwise the floor is meaningless.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_FLOOR_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_FLOOR_H

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/families/points/floor_roots.h"
#include "experiments/lab/bench_run.h"

namespace kinex::families::floors {

// True for scenes in which a floor is possible: at least 3 points with one flight plan each from
// start to end, motions of one degree from 1 to 3. That there are no ties is up to the caller.
bool is_plain(const Scene& scene);

template <std::size_t D>
using Coordinate = FloorPolynomial<D + 1>;

// Along an axis, by object.
template <std::size_t D>
std::vector<Coordinate<D>> coordinates(const Scene& scene, std::size_t axis) {
  std::vector<Coordinate<D>> result;
  for (const SceneObject& object : scene.objects) {
    const std::vector<Rational>& given = object.motion.pieces[0].trajectory.coordinates[axis];
    Coordinate<D>& c = result.emplace_back();
    c.fill(0);
    for (std::size_t i = 0; i < given.size(); ++i) c[i] = given[i].to_double();
  }
  return result;
}

// At a time.
template <std::size_t N>
double value(const FloorPolynomial<N>& p, double t) {
  double v = 0;
  for (std::size_t i = N; i-- > 0;) v = v * t + p[i];
  return v;
}

// run.operator()<D>(start, end) for scenes of degree D. Throws std::invalid_argument unless the scene
// is plain.
template <class Run>
lab::BenchRun run_of_degree(const Scene& scene, const Run& run) {
  if (!is_plain(scene)) throw std::invalid_argument("this scene has no floor");
  const double start = scene.start.to_double(), end = scene.end->to_double();
  if (scene.degree() == 1) return run.template operator()<1>(start, end);
  if (scene.degree() == 2) return run.template operator()<2>(start, end);
  return run.template operator()<3>(start, end);
}

}  // namespace kinex::families::floors

#endif
