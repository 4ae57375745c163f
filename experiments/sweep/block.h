// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of one block of a plan. For plan.cpp only.
#ifndef KINEX_EXPERIMENTS_SWEEP_BLOCK_H
#define KINEX_EXPERIMENTS_SWEEP_BLOCK_H

#include <functional>

#include "experiments/formats/json_node.h"
#include "experiments/sweep/plan.h"

namespace kinex::sweep {

// A block is an object with a member for each axis, a value or an array of values:
//   structure                a name, {"structure": NAME, ..} as in a scene, or an array of these to
//                            be maintained together in one run
//   workload                 a name
//   n, m, degree, dimension, separation, turns    of the workload, as in `kinex gen`
//   seed                     integers, or {"from": A, "to": B}
//   arithmetic, scheduling, audit, until, max_events    of the run, as in `kinex run`
// Calls `take` for every element of the product, in the order of the members above, the last one
// fastest; equal cells may come more than once. Throws InputError that names the member.
void expand_block(const formats::JsonNode& block, PlanCheck check,
                  const std::function<void(RunCell)>& take);

// Throws InputError: the plan, up to this block, has more than kMostCells.
[[noreturn]] void too_many_cells(const formats::JsonNode& block);

}  // namespace kinex::sweep

#endif
