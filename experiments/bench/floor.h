// SPDX-License-Identifier: GPL-3.0-or-later
// The floor: the least that a program must do to handle the events of a kinetic structure.
//
// Plain doubles, no error bounds, no ties, no ledger, no proof, no reports: a failed certificate is
// repaired, and the failure times of the new ones are searched for in the same windows as in kinex.
// The time that a run takes beyond this is the price of everything else. The counts of events must
// agree with those of an exact run; otherwise the floor is meaningless.
#ifndef KINEX_EXPERIMENTS_BENCH_FLOOR_H
#define KINEX_EXPERIMENTS_BENCH_FLOOR_H

#include <cstdint>
#include <string_view>

#include "core/motion/scene.h"

namespace kinex {

struct FloorRun {
  std::uint64_t events = 0;  // certificate failures
  double seconds = 0;        // thread CPU time, set-up excluded
};

// True if there is a floor for scenes of this kind: points on one flight plan each from start to
// end, no ties, motions of one degree from 1 to 3, "sorted_list" (by the first axis) or
// "delaunay_2".
bool has_floor(std::string_view structure, const Scene& scene);

// Runs it from the scene's start to its end, or for `most` events if most > 0.
// Requires has_floor(structure, scene).
FloorRun run_floor(std::string_view structure, const Scene& scene, std::uint64_t most);

}  // namespace kinex

#endif
