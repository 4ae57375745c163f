// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/bench_run.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "experiments/lab/cpu_clock.h"
#include "structures/plan.h"

namespace kinex::lab {

namespace {

// A run that is nearly all set-up is not repeated without end: nor more than this many times as long,
// set-up included, as `least_seconds`.
constexpr double kMostPerLeast = 10;

StageCounts sum_of(const ArithmeticCounters& numbers, StageCounts PredicateCounters::*counts) {
  StageCounts sum{};
  for (const PredicateCounters& predicate : numbers.by_predicate) {
    for (std::size_t stage = 0; stage < sum.size(); ++stage) {
      sum[stage] += (predicate.*counts)[stage];
    }
  }
  return sum;
}

}  // namespace

StageCounts BenchRun::signs() const { return sum_of(numbers, &PredicateCounters::signs); }
StageCounts BenchRun::failures() const { return sum_of(numbers, &PredicateCounters::failures); }
StageCounts BenchRun::looks() const { return sum_of(numbers, &PredicateCounters::looks); }
StageCounts BenchRun::comparisons() const {
  return sum_of(numbers, &PredicateCounters::comparisons);
}

std::uint64_t total(const StageCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

std::uint64_t BenchRun::external() const {
  std::uint64_t sum = 0;
  for (const StructureLedger& ledger : structures) sum += ledger.external;
  return sum;
}

bool same_events(const BenchRun& one, const BenchRun& other) {
  const auto alike = [](const StructureLedger& a, const StructureLedger& b) {
    return !a.corrupt && !b.corrupt && a.failures == b.failures && a.external == b.external;
  };
  return one.events == other.events && alike(one.asked, other.asked) &&
         std::ranges::equal(one.structures, other.structures, alike);
}

BenchRun run_once(const Scene& scene, const BenchWay& way) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = way.events;
  options.scheduling = way.scheduling;
  Simulator simulator(scene, planned_arithmetic(way.arithmetic, scene), options);
  add_structures(simulator, scene);
  if (way.prepare) way.prepare(simulator);
  BenchRun run;
  const double begin = cpu_seconds();
  simulator.start();
  const double built = cpu_seconds();
  run.build = built - begin;
  run.signs_at_start = total(sum_of(simulator.arithmetic().counters(), &PredicateCounters::signs));
  const double started = cpu_seconds();
  const RunStatus status = simulator.run_until(std::nullopt);
  if (way.finish) way.finish(status);
  run.seconds = cpu_seconds() - started;
  run.events = simulator.ledger().events;
  run.peak_bytes = simulator.ledger().peak_bytes;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    run.structures.push_back(simulator.ledger(id));
  }
  run.asked = run.structures[asked_structure(scene)];
  run.numbers = simulator.arithmetic().counters();
  if (way.inspect) way.inspect(simulator);
  return run;
}

std::vector<BenchRun> best_of_rounds(const std::vector<std::function<BenchRun()>>& ways,
                                     BenchRounds rounds) {
  std::vector<BenchRun> best(ways.size());
  for (int round = 0; round < rounds.count; ++round) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      bool first = round == 0;
      double spent = 0;
      const double begun = cpu_seconds();
      do {
        BenchRun run = ways[i]();
        spent += run.seconds;
        if (first || run.seconds < best[i].seconds) best[i] = std::move(run);
        first = false;
      } while (spent < rounds.least_seconds &&
               cpu_seconds() - begun < kMostPerLeast * rounds.least_seconds);
    }
  }
  return best;
}

std::vector<BenchRun> best_runs(const Scene& scene, const std::vector<BenchWay>& ways,
                                BenchRounds rounds) {
  std::vector<std::function<BenchRun()>> runs;
  for (const BenchWay& way : ways) {
    runs.emplace_back([&scene, &way] { return run_once(scene, way); });
  }
  return best_of_rounds(runs, rounds);
}

}  // namespace kinex::lab
