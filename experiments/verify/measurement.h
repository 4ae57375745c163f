// SPDX-License-Identifier: GPL-3.0-or-later
// Measurement: everything that one run of one structure over one scene counted.
#ifndef KINEX_EXPERIMENTS_VERIFY_MEASUREMENT_H
#define KINEX_EXPERIMENTS_VERIFY_MEASUREMENT_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/simulator.h"
#include "experiments/verify/cell.h"

namespace kinex {

struct Measurement {
  std::string arithmetic;
  std::string scene_name;
  std::string scene_hash;
  std::uint64_t seed = 0;
  std::size_t objects = 0;
  RunStatus status = RunStatus::kDone;
  StructureLedger ledger;  // of the structure that was asked for
  // What that cost: the same, and where it reads another structure the sum of both. Added up are
  // failures, rebuilds, groups, certificates (largest numbers too: an upper bound of the largest
  // sum) and certificates changed per event. Its processed events are then all failures, and
  // internal those beyond the changes of the attribute.
  StructureLedger costs;
  RunLedger run;
  ArithmeticCounters numbers;
  std::uint64_t signs_at_start = 0;     // asked for when the structure was built
  std::uint64_t failures_at_start = 0;  // failure times, likewise
  std::vector<std::string> predicates;  // names, by PredicateId
  std::vector<BoundCheck> bounds;
  std::vector<std::string> violations;  // of audits
  Attribute attribute;                  // at the end
  std::string started;                  // UTC
  double seconds = 0;                   // CPU time of the simulation, without set-up and audits

  // No audit found anything wrong and the structure is not corrupt (bounds are judged apart).
  bool clean() const {
    return violations.empty() && !ledger.corrupt && costs.audit_violations == 0;
  }
  // Signs asked for while the scene ran.
  std::uint64_t signs() const;
  // Changes of the scene: flight plans that changed, objects that came and went.
  std::uint64_t scene_changes() const;
  // Failure times asked for by these, and by rebuilding, rather than by events.
  std::uint64_t asked_by_scene() const;
  // A quantity (cell.h). Throws std::invalid_argument for a name that there is not.
  std::uint64_t count_of(const Quantity& quantity) const;
};

// Runs the scene, which asks for one structure, to its end. With AuditLevel::kEvents audits take
// part of `seconds`.
Measurement measure(const Scene& scene, std::string_view arithmetic, SimulatorOptions options);

}  // namespace kinex

#endif
