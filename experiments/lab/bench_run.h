// SPDX-License-Identifier: GPL-3.0-or-later
// BenchRun: one run of a scene in a benchmark, with its times and counts. Times are CPU time of the
// thread. What is compared runs in interleaved rounds, of which the best counts.
#ifndef KINEX_EXPERIMENTS_LAB_BENCH_RUN_H
#define KINEX_EXPERIMENTS_LAB_BENCH_RUN_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "core/motion/scene.h"

namespace kinex::lab {

// What runs otherwise than a simulation (a floor, a replay) fills in `seconds` and what it counts.
struct BenchRun {
  double build = 0;          // seconds of building the structures
  double seconds = 0;        // .. of the run from then on, without the above
  std::uint64_t events = 0;  // certificate failures
  std::uint64_t peak_bytes = 0;
  StructureLedger asked = {};                    // of the first structure of "maintain"
  std::vector<StructureLedger> structures = {};  // of all, those read included, by id
  ArithmeticCounters numbers = {};
  std::uint64_t signs_at_start = 0;  // signs computed by then

  // Signs, failure times, further looks and comparisons, whatever the predicate, by stage.
  StageCounts signs() const;
  StageCounts failures() const;
  StageCounts looks() const;
  StageCounts comparisons() const;
  // External events of all structures.
  std::uint64_t external() const;
};

// The sum over all stages.
std::uint64_t total(const StageCounts& counts);

// Nothing is corrupt, and every structure, those read included, has as many failures and external
// events in both. (ChangesDigest: are these the same ones?)
bool same_events(const BenchRun& one, const BenchRun& other);

// How a scene is run.
struct BenchWay {
  std::string arithmetic = "exact";
  std::uint64_t events = 0;  // it stops after so many; 0: at the end of the scene
  Scheduling scheduling = Scheduling::kLazy;
  std::function<void(Simulator&)> prepare = {};        // before the structures are built
  std::function<void(RunStatus)> finish = {};          // at the end, as part of the run's time
  std::function<void(const Simulator&)> inspect = {};  // afterwards
};

// Runs the scene with all that it maintains, without audits.
BenchRun run_once(const Scene& scene, const BenchWay& way);

struct BenchRounds {
  int count = 1;
  // Of each way in each round: shorter runs are repeated, up to ten times as long with their set-up.
  double least_seconds = 0;
};

// The best run of each way: all ways take turns, `rounds.count` times.
std::vector<BenchRun> best_of_rounds(const std::vector<std::function<BenchRun()>>& ways,
                                     BenchRounds rounds);

// Those of one scene in several ways.
std::vector<BenchRun> best_runs(const Scene& scene, const std::vector<BenchWay>& ways,
                                BenchRounds rounds);

}  // namespace kinex::lab

#endif
