// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/run_outcome.h"

namespace kinex::formats {

Attribute value_now(const Simulator& simulator, StructureId id) {
  if (simulator.ledger(id).corrupt || simulator.is_torn()) return {Attribute::Shape::kObject, {}};
  return simulator.structure(id).attribute();
}

RunCounts counts_of(const Simulator& simulator) {
  RunCounts counts;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    const StructureLedger& ledger = simulator.ledger(id);
    counts.external += ledger.external;
    counts.internal += ledger.internal;
    counts.failures += ledger.failures;
    counts.records += ledger.records;
  }
  counts.instants = simulator.ledger().instants;
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
