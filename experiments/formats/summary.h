// SPDX-License-Identifier: GPL-3.0-or-later
// The summary of a run as JSON, for other programs.
#ifndef KINEX_EXPERIMENTS_FORMATS_SUMMARY_H
#define KINEX_EXPERIMENTS_FORMATS_SUMMARY_H

#include <string>

#include "experiments/formats/provenance.h"
#include "experiments/formats/run_outcome.h"

namespace kinex::formats {

// {"scene", "scene_hash", "arithmetic", "status", "time", "objects", counts, "log_digest",
//  "structures": {LABEL: {counts, "by_kind", "certificates", "audit", "bounds", "attribute"}},
//  "samples", "numbers", "seconds", "peak_bytes", "provenance"}, and a newline
//
// Counts are those of run_outcome.h: "events" ("processed" of a structure), "external", "internal",
// "failures", "records". "seconds" are CPU time of the run's thread, with wall time in "wall". In
// an exact arithmetic everything but "seconds", "peak_bytes" and "provenance" is the same on every
// machine.
// Schema: experiments/schemas/summary.schema.json.
std::string write_summary(const Simulator& simulator, const RunOutcome& outcome,
                          const std::string& scene_hash, const std::string& log_digest,
                          const Provenance& provenance);

}  // namespace kinex::formats

#endif
