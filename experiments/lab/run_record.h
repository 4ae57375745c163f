// SPDX-License-Identifier: GPL-3.0-or-later
// RunRecord: the counts of one exact run of one structure.
#ifndef KINEX_EXPERIMENTS_LAB_RUN_RECORD_H
#define KINEX_EXPERIMENTS_LAB_RUN_RECORD_H

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/lab/scene_change.h"
#include "experiments/lab/workload.h"

namespace kinex::lab {

// Identifies a run.
struct RunKey {
  std::string structure;
  std::string workload;
  WorkloadParameters parameters = {.n = 0, .dimension = 2};
  const SceneChange* change = nullptr;  // nullptr: none; of the number seed - 1
  bool forever = false;                 // the scene has no end: run until no event is left
  std::uint64_t max_events = 0;         // the run stops there; 0: no limit

  // "convex_hull_2 uniform-square n=100 d=2 seed=1 forever"
  std::string text() const;
};

struct RunRecord {
  std::string key;                    // RunKey::text()
  std::uint64_t processed = 0;        // certificate failures, over all structures that were built
  std::uint64_t external = 0;         // of the requested structure
  std::uint64_t max_live = 0;         // certificates, over all structures that were built
  std::uint64_t max_per_object = 0;   // likewise
  std::uint64_t signs = 0;            // computed after the start
  std::vector<std::uint64_t> solved;  // by degree: failure times computed
  std::map<std::string, std::uint64_t> kinds;  // events of the requested structure, by kind
  std::uint64_t peak_bytes = 0;
  double seconds_setup = 0;  // CPU
  double seconds = 0;        // CPU, of the simulation
  bool clean = true;         // audits and bounds
  std::string trouble;       // the violation, if not clean
};

Scene scene_for(const RunKey& key);  // maintains the structure of the key only

// Runs it in `exact` with an audit at the end. nullopt if `go_on` (called now and then) is false.
std::optional<RunRecord> run_record(const RunKey& key, const std::function<bool()>& go_on,
                                    const std::atomic<bool>* interrupt = nullptr);

}  // namespace kinex::lab

#endif
