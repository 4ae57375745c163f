// SPDX-License-Identifier: GPL-3.0-or-later
// Measurement: all counts of one run of one structure over one scene.
#ifndef KINEX_EXPERIMENTS_LAB_MEASUREMENT_H
#define KINEX_EXPERIMENTS_LAB_MEASUREMENT_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/lab/cell.h"

namespace kinex::lab {

struct Measurement {
  std::string arithmetic;
  std::string scene_name;
  std::string scene_hash;
  std::uint64_t seed = 0;
  std::size_t objects = 0;
  RunStatus status = RunStatus::kDone;
  StructureLedger ledger;  // of the requested structure
  // Its costs: the same ledger, or, if it reads another structure, the sum of both ledgers: of
  // failures, rebuilds, groups, certificates, certificates changed per event, and of the largest
  // numbers of certificates (an upper bound on the largest sum). Processed events are then all
  // failures, and internal events are those that did not change the attribute.
  StructureLedger costs;
  RunLedger run;
  ArithmeticCounters numbers;
  std::uint64_t signs_at_start = 0;     // computed when the structure was built
  std::uint64_t failures_at_start = 0;  // failure times, likewise
  std::vector<std::string> predicates;  // names, by PredicateId
  std::vector<BoundCheck> bounds;
  std::vector<std::string> violations;  // of audits
  Attribute attribute;                  // at the end
  std::string started;                  // UTC
  double seconds = 0;                   // CPU time of the simulation, without set-up and audits

  // True if no audit found a violation and the structure is not corrupt (bounds are judged apart).
  bool clean() const {
    return violations.empty() && !ledger.corrupt && costs.audit_violations == 0;
  }
  // Signs computed while the scene ran.
  std::uint64_t signs() const;
  // Changes of the scene: flight plans that changed, objects that came and went.
  std::uint64_t scene_changes() const;
  // Failure times computed for changes of the scene and for rebuilds, not for events.
  std::uint64_t asked_by_scene() const;
  // A quantity (cell.h). Throws std::invalid_argument for an unknown name.
  std::uint64_t count_of(const Quantity& quantity) const;
};

// Runs the scene, which maintains one structure, to its end. With AuditLevel::kEvents `seconds`
// includes the audits.
Measurement measure(const Scene& scene, std::string_view arithmetic, SimulatorOptions options);

}  // namespace kinex::lab

#endif
