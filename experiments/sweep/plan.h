// SPDX-License-Identifier: GPL-3.0-or-later
// Plan: the cells of a sweep, and their limits. A plan is a file of the form of
// schemas/plan.schema.json: blocks, each a product of axes, or a selection of an experiment.
#ifndef KINEX_EXPERIMENTS_SWEEP_PLAN_H
#define KINEX_EXPERIMENTS_SWEEP_PLAN_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/sweep/plan_cell.h"
#include "experiments/sweep/experiment.h"
#include "experiments/sweep/run_cell.h"

namespace kinex::sweep {

inline constexpr std::size_t kMostCells = 200000;  // some 300 MB in memory
inline constexpr int kMostShards = 1000000;

// The limits of one cell. 0: no limit.
struct Limits {
  int seconds = 0;    // CPU time
  int megabytes = 0;  // of 2^20 bytes: address space
};

struct PlanText {
  std::string name;
  std::string text;  // the file as canonical JSON
  std::string hash;  // the SHA-256 of that
};

struct Plan : PlanText {
  Limits limits;
  // Each key once, even if several blocks have it. In the order of descending expected cost, then
  // ascending key: the same on every machine.
  std::vector<PlanCell> cells;
};

// The checks of a reader.
enum class PlanCheck {
  kFormOnly,  // the form of the plan only: for a plan that was run
  kScenes,    // also that each structure can be maintained in the smallest scene of its kind
};

// Throws InputError with file, JSON path, offending text and remedy. `file` is for messages only.
Plan parse_plan(std::string_view text, const std::string& file, PlanCheck check,
                const Experiments& experiments = {});
Plan read_plan(const std::string& path, const Experiments& experiments = {});
// The plan of a selection, and its file alone.
PlanText plan_text(const Selection& selection);
Plan plan_of(const Selection& selection, const Experiments& experiments);
// A run from its cell_text, or from a block of one cell. Throws InputError as parse_plan does.
RunCell parse_cell(std::string_view text, const std::string& file);

struct Shard {
  int index = 0;
  int count = 1;
};
// "3/64": shard 3 of 64, counted from 0. Throws InputError that names the option --shard.
Shard parse_shard(const std::string& text);
std::string shard_text(const Shard& shard);

// Cells i, i + N, i + 2N, .. of the plan. The shards of a plan are disjoint and cover it.
std::vector<PlanCell> shard_of(const Plan& plan, const Shard& shard);

}  // namespace kinex::sweep

#endif
