// SPDX-License-Identifier: GPL-3.0-or-later
// Cell: one run of a sweep, as data. Everything that decides its exact results is in it but the
// commit of the program.
#ifndef KINEX_EXPERIMENTS_SWEEP_SWEEP_CELL_H
#define KINEX_EXPERIMENTS_SWEEP_SWEEP_CELL_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "core/motion/scene.h"
#include "experiments/lab/workload.h"

namespace kinex::sweep {

struct Cell {
  // Canonical JSON of what is maintained: a name, an entry of "maintain" as in a scene, or an array
  // of these, which one run maintains together.
  std::string structure;
  std::vector<std::string> maintain;  // the same, as set_maintain takes it
  std::string workload;
  WorkloadParameters parameters;  // resolved
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
std::string cell_text(const Cell& cell);

// 64 hexadecimal digits: the SHA-256 of cell_text. The same on every machine.
std::string cell_key(const Cell& cell);

// Grows with the time that the cell takes. An integer, so that every machine orders cells alike; a
// rough one: n^2 times the degree, and a factor for the arithmetic.
std::uint64_t expected_cost(const Cell& cell);

// What the simulator is told. Requires valid names.
Scheduling scheduling_of(const Cell& cell);
AuditLevel audit_of(const Cell& cell);

// The scene as `kinex gen --maintain` writes it, over the whole time of the workload. Throws
// InputError for a structure that cannot be maintained in it.
Scene scene_of(const Cell& cell);
// Ends the scene at `until`, if the cell has one. Throws InputError if that is not within its time.
void shorten(Scene& scene, const Cell& cell);

}  // namespace kinex::sweep

#endif
