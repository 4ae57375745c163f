// SPDX-License-Identifier: GPL-3.0-or-later
// Plan: the cells of a sweep, and their limits. A plan is a file of the form of
// schemas/plan.schema.json: blocks, each a product of axes.
#ifndef KINEX_EXPERIMENTS_SWEEP_PLAN_H
#define KINEX_EXPERIMENTS_SWEEP_PLAN_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/sweep/sweep_cell.h"

namespace kinex::sweep {

inline constexpr std::size_t kMostCells = 200000;  // some 300 MB in memory
inline constexpr int kMostShards = 1000000;

// Of one cell. 0: none.
struct Limits {
  int seconds = 0;    // CPU time
  int megabytes = 0;  // of 2^20 bytes: address space
};

struct PlannedCell {
  Cell cell;
  std::string text;  // cell_text
  std::string key;   // cell_key
  std::uint64_t cost = 0;
};

struct Plan {
  std::string name;
  std::string text;  // the file as canonical JSON
  std::string hash;  // the SHA-256 of that
  Limits limits;
  // No key twice, however many blocks have it. Descending expected cost, then ascending key: the
  // same order on every machine.
  std::vector<PlannedCell> cells;
};

// What a reader looks at beyond the form of the plan.
enum class PlanCheck {
  kFormOnly,  // of a plan that was run
  kScenes,    // makes the smallest scene of each kind: can the structure be maintained in it?
};

// Throws InputError with file, JSON path, offending text and remedy. `file` is for messages only.
Plan parse_plan(std::string_view text, const std::string& file, PlanCheck check);
Plan read_plan(const std::string& path);
// One cell from its cell_text, or from a block of one cell. Throws InputError as parse_plan does.
Cell parse_cell(std::string_view text, const std::string& file);

struct Shard {
  int index = 0;
  int count = 1;
};
// "3/64": shard 3 of 64, counted from 0. Throws InputError that names the option --shard.
Shard parse_shard(const std::string& text);
std::string shard_text(const Shard& shard);

// Cells i, i + N, i + 2N, .. of the plan. The shards of a plan are disjoint and cover it.
std::vector<PlannedCell> shard_of(const Plan& plan, const Shard& shard);

}  // namespace kinex::sweep

#endif
