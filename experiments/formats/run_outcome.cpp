// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/run_outcome.h"

#include "structures/plan.h"

namespace kinex::formats {

Attribute value_now(const Simulator& simulator, StructureId id) {
  if (simulator.ledger(id).corrupt || simulator.is_torn()) return {Attribute::Shape::kObject, {}};
  return simulator.structure(id).attribute();
}

namespace {

void add(const StructureLedger& ledger, RunCounts& counts) {
  counts.external += ledger.external;
  counts.internal += ledger.internal;
  counts.failures += ledger.failures;
  counts.records += ledger.records;
}

}  // namespace

RunCounts counts_of(const Simulator& simulator) {
  RunCounts counts;
  for (StructureId id = 0; id < simulator.structures(); ++id) add(simulator.ledger(id), counts);
  counts.instants = simulator.ledger().instants;
  return counts;
}

CountsByUse counts_by_use(const Simulator& simulator) {
  const std::vector<PlannedStructure> plan = plan_structures(simulator.scene());
  CountsByUse counts;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    // A structure outside of the plan was added by a program of its own, which wants it.
    const bool asked =
        id >= plan.size() || plan[id].request.label != simulator.label(id) || plan[id].asked;
    add(simulator.ledger(id), asked ? counts.maintained : counts.read);
  }
  counts.maintained.instants = counts.read.instants = simulator.ledger().instants;
  return counts;
}

bool RunOutcome::clean(const Simulator& simulator) const {
  if (!simulator.violations().empty()) return false;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    const StructureLedger& ledger = simulator.ledger(id);
    if (ledger.corrupt || ledger.audit_violations > 0) return false;
    for (const BoundCheck& bound : bounds[id]) {
      if (!bound.holds) return false;
    }
  }
  return true;
}

std::string_view status_name(RunStatus status) {
  switch (status) {
    case RunStatus::kDone:
      return "done";
    case RunStatus::kLimit:
      return "limit";
    case RunStatus::kInterrupted:
      return "interrupted";
  }
  return "";
}

}  // namespace kinex::formats
