// SPDX-License-Identifier: GPL-3.0-or-later
// One scene in several arithmetics, each compared with the exact run. States are those of the
// requested structure; if it reads another one, the events, instants, times and memory of both are
// counted.
#ifndef KINEX_EXPERIMENTS_TRADE_CASE_RUN_H
#define KINEX_EXPERIMENTS_TRADE_CASE_RUN_H

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/sweep/cell_source.h"
#include "experiments/trade/bits_needed.h"
#include "experiments/trade/cases.h"
#include "experiments/trade/deviation.h"

namespace kinex::trade {

enum class Ending {
  kEnded,    // the run reached the end of its scene
  kCorrupt,  // the structure became corrupt and detected it
  kEndless,  // stopped after many more events than the exact run has
  kGaveUp,   // stopped at the limit of time
  kThrew,    // the run threw an exception: a bug
};
std::string_view ending_name(Ending ending);  // "ended", "corrupt", ..

// The quality of a run, best first.
enum class Standing {
  kSame,   // the exact run's events, at instants in the same order, and every audited state valid
  kValid,  // other events, or in another order; yet every audited state was valid
  kWrong,  // a state was wrong, or the run did not reach its end
};

struct TradeRun {
  std::string arithmetic;
  Ending ending = Ending::kEnded;
  std::string trouble;       // the reason of corruption, or the exception
  bool guard_fired = false;  // corrupt because a guard detected endless repairs or rebuilds
  std::uint64_t events = 0;
  std::optional<double> seconds;  // CPU time of the whole run without audits and reports, best of the rounds
  std::uint64_t peak_bytes = 0;   // motions, certificates, queue and structure, from the ledger
  Deviation deviation;
  bool differs = false;  // of an exact arithmetic: its events are not those of `exact`
  // Checkpoints are up to ten times (checkpoints.h) and the end. At each the state is compared
  // with an independent exact computation; one that was not reached is not valid.
  int checkpoints = 0, valid = 0;
  bool valid_at_end = false;
  std::optional<Rational> first_wrong;  // the first checkpoint that is not valid
  std::string violation;                // the audit's message there

  Standing standing() const;
};

struct CaseResult {
  TradeCase which;
  std::string scene_name, scene_hash;
  std::size_t objects = 0;
  std::uint64_t events = 0;  // of the exact run
  BitsNeeded bits;
  std::vector<TradeRun> runs;  // `exact` first
  // Why there is no reference: the exact run gave up or threw; empty if all is well.
  std::string problem;
  bool gave_up = false;
  double seconds = 0;  // all of it, wall clock

  const TradeRun* run_in(std::string_view arithmetic) const;
  // Time and memory over those of `double`; nullopt where either is missing or too short.
  std::optional<double> time_ratio(const TradeRun& run) const;
  std::optional<double> memory_ratio(const TradeRun& run) const;
  // An exact arithmetic was wrong, two exact ones differ, or an exception was thrown; empty if
  // none.
  std::vector<std::string> faults() const;
};

struct TradeOptions {
  int jobs = 1;  // more than one makes time ratios noisy
  // `exact` and `double` are run in any case.
  std::vector<std::string> arithmetics = trade_arithmetics();
  double max_seconds = 120;  // of one run
  // An inexact run is endless after events_factor times the exact run's events, plus events_more.
  std::uint64_t events_factor = 4;
  std::uint64_t events_more = 10000;
  sweep::CellSource source;                      // runs cases, or has their records
  const std::atomic<bool>* interrupt = nullptr;  // as in SimulatorOptions, of runs in this process
};

// In this process; nullopt if source.go_on returns false.
std::optional<CaseResult> run_case(const TradeCase& which, const TradeOptions& options);

// The bits needed by the instants of the scene's exact run; nullopt if go_on returns false or the
// run gave up.
std::optional<BitsNeeded> bits_of_scene(const Scene& scene, const TradeOptions& options);

}  // namespace kinex::trade

#endif
