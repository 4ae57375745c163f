// SPDX-License-Identifier: GPL-3.0-or-later
// The four measures of a kinetic data structure (responsiveness, locality, compactness,
// efficiency), as counted, side by side for structures that maintain the same attribute on the same
// scenes.
#ifndef KINEX_EXPERIMENTS_LAB_MEASURES_H
#define KINEX_EXPERIMENTS_LAB_MEASURES_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/lab/judge.h"
#include "experiments/lab/table.h"

namespace kinex::lab {

// Over all scenes of a cell. Certificates mostly come and go in pairs; both are counted.
struct Measures {
  double events = 0;               // mean, processed; also of the structure read (costs)
  double external = 0;             // mean, changes of the attribute
  double internal = 0;             // mean, all other events
  std::uint64_t most_changed = 0;  // responsiveness: certificates created and retracted by an event
  double mean_changed = 0;         // the mean of that
  std::uint64_t per_object = 0;    // locality: the most certificates of one object
  std::uint64_t certificates = 0;  // compactness: the most certificates at one time
  // Mean number of failure times computed for a change of the scene: a new flight plan, an object
  // that appears or disappears. Negative if there was no change.
  double asked_by_scene = -1;
  // Mean number of signs computed per event or change of the scene. Negative if audits computed
  // signs, too.
  double signs = -1;
  // Mean CPU seconds of a run, without set-up and audits. Negative if audits were made at events.
  double seconds = -1;
  // Efficiency: internal events per external one; negative if there was no external one.
  double internal_per_external() const { return external > 0 ? internal / external : -1; }
};
// Of the first `trials` scenes, or of all if there are fewer. Requires at least one.
Measures measures_of(const CellResult& cell, std::size_t trials);
Measures measures_of(const CellResult& cell);

// One table per comparison: structures are compared on the scenes that all of them have.
std::vector<Table> comparison_tables(const std::vector<CellResult>& cells);

}  // namespace kinex::lab

#endif
