// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/run_record.h"

#include <algorithm>

#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/scene_run.h"
#include "structures/plan.h"

namespace kinex::lab {

namespace {

std::uint64_t signs_of(const ArithmeticCounters& counters) {
  std::uint64_t sum = 0;
  for (const PredicateCounters& predicate : counters.by_predicate) {
    for (const std::uint64_t count : predicate.signs) sum += count;
  }
  return sum;
}

}  // namespace

std::string RunKey::text() const {
  std::string text = structure + " " + workload + " n=" + std::to_string(parameters.n) +
                     " d=" + std::to_string(parameters.dimension) +
                     " seed=" + std::to_string(parameters.seed);
  if (parameters.m != 0) text += " m=" + std::to_string(parameters.m);
  if (parameters.separation) text += " separation=" + parameters.separation->to_string();
  if (parameters.turns != -1) text += " turns=" + std::to_string(parameters.turns);
  if (change != nullptr) text += " " + std::string(change->name);
  if (forever) text += " forever";
  if (max_events != 0) text += " events=" + std::to_string(max_events);
  return text;
}

Scene scene_for(const RunKey& key) {
  Scene scene = generate_scene(key.workload, key.parameters, key.structure);
  if (key.change != nullptr) key.change->apply(scene, static_cast<int>(key.parameters.seed) - 1);
  if (key.forever) scene.end.reset();
  return scene;
}

std::optional<RunRecord> run_record(const RunKey& key, const std::function<bool()>& go_on,
                                    const std::atomic<bool>* interrupt) {
  const Scene scene = scene_for(key);
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = key.max_events;
  options.progress = [&](const Simulator&) { return go_on(); };
  options.interrupt = interrupt;
  double begin = cpu_seconds();
  const auto simulator = make_simulator(scene, "exact", std::move(options));
  const GmpGuard guard(&simulator->deadline());
  simulator->start();
  RunRecord record;
  const std::uint64_t signs_at_start = signs_of(simulator->arithmetic().counters());
  record.key = key.text();
  record.seconds_setup = cpu_seconds() - begin;
  begin = cpu_seconds();
  const RunStatus status = simulator->run_until(std::nullopt);
  record.seconds = cpu_seconds() - begin;
  record.signs = signs_of(simulator->arithmetic().counters()) - signs_at_start;
  if (status == RunStatus::kInterrupted || !go_on()) return std::nullopt;
  const StructureId id = asked_structure(scene);
  if (status == RunStatus::kDone && !simulator->audit()) {
    record.clean = false;
    record.trouble = simulator->violations().empty() ? "audit" : simulator->violations().front();
  }
  if (simulator->is_broken()) {
    record.clean = false;
    record.trouble = simulator->out_of_memory() ? "memory" : "stopped";
  }
  for (std::size_t s = 0; s < simulator->structures(); ++s) {
    const auto other = static_cast<StructureId>(s);
    for (const BoundCheck& bound : simulator->bounds(other)) {
      if (!bound.holds) {
        record.clean = false;
        record.trouble = "bound " + bound.id;
      }
    }
    const StructureLedger& ledger = simulator->ledger(other);
    record.max_live += ledger.max_live;
    record.max_per_object += ledger.max_per_object;
  }
  const StructureLedger& ledger = simulator->ledger(id);
  record.processed = simulator->ledger().events;
  record.external = ledger.external;
  record.kinds = ledger.by_kind;
  record.solved = simulator->arithmetic().counters().polynomials_solved;
  record.peak_bytes = simulator->ledger().peak_bytes;
  return record;
}

}  // namespace kinex::lab
