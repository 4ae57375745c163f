// SPDX-License-Identifier: GPL-3.0-or-later
// Walks, as a recording of pedestrians has them: a fix every tenth, in thousandths, and a new flight plan at
// every fix. Loading such a scene, and changing plans, cost more than the events between.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/points/workloads.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

// Of the place where walks begin, in thousandths.
constexpr std::int64_t kRoom = 15000;
// Thousandths in a tenth: at most so fast at first, and so much faster or slower after a fix.
constexpr std::int64_t kFastest = 150, kTurn = 15;

}  // namespace

void generate_walks(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = lab::fraction(parameters.m, 10);
  const auto axes = static_cast<std::size_t>(scene.dimension);
  for (int i = 0; i < parameters.n; ++i) {
    std::vector<std::int64_t> place, speed;
    for (std::size_t axis = 0; axis < axes; ++axis) place.push_back(random.between(0, kRoom));
    for (std::size_t axis = 0; axis < axes; ++axis) speed.push_back(random.between(-kFastest, kFastest));
    Motion motion;
    for (int fix = 0; fix < parameters.m; ++fix) {
      MotionPiece piece;
      if (fix > 0) piece.from = lab::fraction(fix, 10);
      if (fix + 1 < parameters.m) piece.to = lab::fraction(fix + 1, 10);
      for (std::size_t axis = 0; axis < axes; ++axis) {
        piece.trajectory.coordinates.push_back(
            {lab::fraction(place[axis] - speed[axis] * fix, 1000), lab::fraction(speed[axis], 100)});
        place[axis] += speed[axis];
        speed[axis] += random.between(-kTurn, kTurn);
      }
      piece.trajectory.normalise();
      motion.pieces.push_back(std::move(piece));
    }
    scene.objects.push_back({"p" + std::to_string(i), std::move(motion)});
  }
}

}  // namespace kinex::families
