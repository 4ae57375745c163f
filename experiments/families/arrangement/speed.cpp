// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `bench/run speed` of this family.
#include <utility>

#include "experiments/families/arrangement/experiments.h"
#include "experiments/families/points/speed_rows.h"

namespace kinex::families {

std::vector<lab::SpeedRow> arrangement_speed_rows(int scale) {
  std::vector<lab::SpeedRow> rows;
  lab::SpeedRow incidences = random_row("incidences_all", 1, lab::scaled_size(200, scale));
  incidences.workload = "random-lines-and-points";
  rows.push_back(std::move(incidences));
  return rows;
}

}  // namespace kinex::families
