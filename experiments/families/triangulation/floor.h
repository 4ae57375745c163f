// SPDX-License-Identifier: GPL-3.0-or-later
// The floor of Delaunay triangulations in the plane: flips. See points/floor.h.
#ifndef KINEX_EXPERIMENTS_FAMILIES_TRIANGULATION_FLOOR_H
#define KINEX_EXPERIMENTS_FAMILIES_TRIANGULATION_FLOOR_H

#include <cstdint>

#include "core/motion/scene.h"
#include "experiments/lab/bench_run.h"

namespace kinex::families {

// Runs it from the scene's start to its end, or for `most` events if most > 0: the events and the
// seconds, set-up excluded. The scene maintains the triangulation; its first one is the exact one.
// Throws std::invalid_argument for scenes without a floor (floors::is_plain), and those of other
// dimensions than 2.
lab::BenchRun run_delaunay_floor(const Scene& scene, std::uint64_t most);

}  // namespace kinex::families

#endif
