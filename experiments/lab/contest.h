// SPDX-License-Identifier: GPL-3.0-or-later
// SpeedContest: the cost of exactness on one scene: CPU time in `exact` over CPU time in `double`.
#ifndef KINEX_EXPERIMENTS_LAB_CONTEST_H
#define KINEX_EXPERIMENTS_LAB_CONTEST_H

#include <optional>

#include "experiments/lab/measurement.h"

namespace kinex::lab {

struct SpeedContest {
  Measurement rival;  // the run in `double`
  // CPU time of the simulation in `exact` over that in `double`, both the best of the rounds;
  // nullopt if the time is too short to measure, or a run gave up.
  std::optional<double> ratio;
  // `double` handled as many events as `exact` and ended with the same attribute.
  bool same_counts = false;
};

// `exact`: the measurement of the scene in exact arithmetic with these `options`, the first of its rounds if it was not
// audited after every event. The two arithmetics alternate until each has taken 20 ms: at least one round, at most
// 40 rounds, and no further one after 50 ms. nullopt if the runs were interrupted.
std::optional<SpeedContest> compare_with_double(const Scene& scene, const Measurement& exact,
                                                SimulatorOptions options);

}  // namespace kinex::lab

#endif
