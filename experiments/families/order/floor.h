// SPDX-License-Identifier: GPL-3.0-or-later
// The floor of sorted lists: swaps of neighbours along the first axis. See points/floor.h.
#ifndef KINEX_EXPERIMENTS_FAMILIES_ORDER_FLOOR_H
#define KINEX_EXPERIMENTS_FAMILIES_ORDER_FLOOR_H

#include <cstdint>

#include "core/motion/scene.h"
#include "experiments/lab/bench_run.h"

namespace kinex::families {

// Runs it from the scene's start to its end, or for `most` events if most > 0: the events and the
// seconds, set-up excluded.
// Throws std::invalid_argument for scenes without a floor (floors::is_plain).
lab::BenchRun run_list_floor(const Scene& scene, std::uint64_t most);

}  // namespace kinex::families

#endif
