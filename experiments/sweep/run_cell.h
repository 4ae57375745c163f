// SPDX-License-Identifier: GPL-3.0-or-later
// RunCell: one run of a sweep, as data. Together with the commit of the program it determines the
// exact results.
#ifndef KINEX_EXPERIMENTS_SWEEP_RUN_CELL_H
#define KINEX_EXPERIMENTS_SWEEP_RUN_CELL_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "core/motion/scene.h"
#include "experiments/lab/workload.h"

namespace kinex::sweep {

struct RunCell {
  // Canonical JSON of the structures: a name, an entry of "maintain" as in a scene, or an array of
  // these, which one run maintains together.
  std::string structure;
  std::vector<std::string> maintain;  // the same in the form of set_maintain
  std::string workload;
  lab::WorkloadParameters parameters;  // resolved
  std::string arithmetic = "exact";
  std::string scheduling = "lazy";
  std::string audit = "end";
  std::optional<Rational> until;  // the end of the run, before that of the workload
  int max_events = 0;             // certificate failures after which the run ends; 0: no limit
};

// The cell as canonical JSON, a block of a plan (block.h) with one cell. Equal cells give equal
// bytes. Its members:
//   structure, workload, n, dimension, arithmetic             always
//   m, degree, separation, turns, seed                        if the workload has a choice
//   scheduling, audit, until, max_events                      if they are not the default
std::string cell_text(const RunCell& cell);

// 64 hexadecimal digits: the SHA-256 of cell_text. The same on every machine.
std::string cell_key(const RunCell& cell);

// A rough measure of the cell's running time: n^2 times the degree times a factor for the
// arithmetic. An integer, so that every machine orders cells alike.
std::uint64_t expected_cost(const RunCell& cell);

// The options of the simulator. Requires valid names.
Scheduling scheduling_of(const RunCell& cell);
AuditLevel audit_of(const RunCell& cell);

// The scene as `kinex gen --maintain` writes it, over the whole time of the workload. Throws
// InputError for a structure that cannot be maintained in it.
Scene scene_of(const RunCell& cell);
// Ends the scene at `until`, if the cell has one. Throws InputError if that is not within its time.
void shorten(Scene& scene, const RunCell& cell);

}  // namespace kinex::sweep

#endif
