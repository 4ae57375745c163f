// SPDX-License-Identifier: GPL-3.0-or-later
// The outcome of a run of a scene, as data: samples, bounds, counts.
#ifndef KINEX_EXPERIMENTS_FORMATS_RUN_OUTCOME_H
#define KINEX_EXPERIMENTS_FORMATS_RUN_OUTCOME_H

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/engine/simulator.h"
#include "structures/parts/range_search.h"

namespace kinex::formats {

// The attribute right after now; an empty object (null) for a corrupt structure.
Attribute value_now(const Simulator& simulator, StructureId id);

// The points in a box right after the time of a sample.
struct BoxAnswer {
  struct OfStructure {
    StructureId structure;
    std::vector<ObjectId> ids;  // ascending
    QueryCounts counts;
  };
  std::vector<std::array<Rational, 2>> box;  // as in BoxQuery
  std::vector<OfStructure> answers;          // of all structures that search and are not corrupt
};

struct Sample {
  Rational t;
  std::vector<Attribute> values;  // by StructureId, right after t
  std::vector<BoxAnswer> queries;
};

struct RunOutcome {
  RunStatus status = RunStatus::kDone;
  std::vector<Sample> samples;
  std::vector<std::vector<BoundCheck>> bounds;  // by StructureId

  // Every bound holds, no audit found a violation, no structure is corrupt.
  bool clean(const Simulator& simulator) const;
};

// The counts of a run, over all structures. Reports, summaries and logs use these words:
//   certificate failures   failures of certificates that were handled
//   events                 external and internal
//   log records            lines of an event log between its header and its last line
struct RunCounts {
  std::uint64_t external = 0, internal = 0, failures = 0, records = 0, instants = 0;
  std::uint64_t events() const { return external + internal; }
};
RunCounts counts_of(const Simulator& simulator);

// Structures of two kinds: those that the scene maintains, and those that exist for them to read. Of each kind the
// counts alone; "instants" are those of the whole run.
struct CountsByUse {
  RunCounts maintained, read;
};
CountsByUse counts_by_use(const Simulator& simulator);

std::string_view status_name(RunStatus status);  // "done", "limit", "interrupted"

}  // namespace kinex::formats

#endif
