// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/measurement.h"

#include <algorithm>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <utility>

#include "experiments/formats/scene_writer.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/scene_run.h"
#include "structures/plan.h"

namespace kinex::lab {

namespace {

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts;
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

std::uint64_t one_count(const Measurement& run, const std::string& name) {
  if (name == "processed") return run.costs.processed;
  if (name == "external") return run.ledger.external;
  if (name == "internal") return run.costs.internal;
  if (name.rfind("kind.", 0) == 0) {
    const auto found = run.ledger.by_kind.find(name.substr(5));
    return found == run.ledger.by_kind.end() ? 0 : found->second;
  }
  if (name == "signs_per_event") {
    const std::uint64_t events = run.costs.processed + run.scene_changes();
    return events == 0 ? 0 : (run.signs() + events - 1) / events;
  }
  throw std::invalid_argument("no quantity " + name);
}

std::uint64_t all_signs(const ArithmeticCounters& numbers) {
  std::uint64_t sum = 0;
  for (const PredicateCounters& predicate : numbers.by_predicate) {
    for (const std::uint64_t count : predicate.signs) sum += count;
  }
  return sum;
}

std::uint64_t all_failures(const ArithmeticCounters& numbers) {
  std::uint64_t sum = 0;
  for (const PredicateCounters& predicate : numbers.by_predicate) {
    for (const std::uint64_t count : predicate.failures) sum += count;
  }
  return sum;
}

void add(const PredicateCounters& one, PredicateCounters& sum) {
  for (std::size_t s = 0; s < kStages; ++s) {
    sum.signs[s] += one.signs[s];
    sum.failures[s] += one.failures[s];
    sum.looks[s] += one.looks[s];
    sum.comparisons[s] += one.comparisons[s];
  }
}

void add(const ChangeStatistics& one, ChangeStatistics& sum) {
  sum.events += one.events;
  sum.total += one.total;
  sum.max = std::max(sum.max, one.max);
  for (std::size_t k = 0; k < one.histogram.size(); ++k) sum.histogram[k] += one.histogram[k];
}

// Adds the costs of a structure that is read to those of its reader.
void add_costs(const StructureLedger& read, StructureLedger& sum) {
  sum.failures += read.failures;
  sum.rebuilds += read.rebuilds;
  for (const auto& [reason, count] : read.rebuild_reasons) sum.rebuild_reasons[reason] += count;
  sum.simultaneous_groups += read.simultaneous_groups;
  sum.largest_group = std::max(sum.largest_group, read.largest_group);
  sum.certificates_created += read.certificates_created;
  sum.certificates_retracted += read.certificates_retracted;
  sum.live += read.live;
  sum.max_live += read.max_live;
  sum.max_per_object += read.max_per_object;
  add(read.created_per_event, sum.created_per_event);
  add(read.retracted_per_event, sum.retracted_per_event);
  sum.audit_checks += read.audit_checks;
  sum.audit_violations += read.audit_violations;
  sum.processed = std::max(sum.failures, sum.external);
  sum.internal = sum.processed - sum.external;
}

}  // namespace

std::uint64_t Measurement::signs() const { return all_signs(numbers) - signs_at_start; }

std::uint64_t Measurement::scene_changes() const {
  return ledger.motion_updates + ledger.insertions + ledger.erasures;
}

std::uint64_t Measurement::asked_by_scene() const {
  return all_failures(numbers) - failures_at_start - costs.created_per_event.total;
}

std::uint64_t Measurement::count_of(const Quantity& quantity) const {
  std::uint64_t sum = 0;
  std::size_t begin = 0;
  while (begin <= quantity.size()) {
    const std::size_t end = std::min(quantity.find('+', begin), quantity.size());
    const std::string name = quantity.substr(begin, end - begin);
    sum += one_count(*this, name);
    begin = end + 1;
  }
  return sum;
}

Measurement measure(const Scene& scene, std::string_view arithmetic, SimulatorOptions options) {
  Measurement result;
  result.started = utc_now();
  result.scene_name = scene.name;
  result.objects = scene.objects.size();
  // The audit at the end is made separately, so that its time is not measured.
  const bool audit_end = options.audit == AuditLevel::kEnd;
  if (audit_end) options.audit = AuditLevel::kNone;
  const std::unique_ptr<Simulator> simulator =
      make_simulator(scene, std::string(arithmetic), std::move(options));
  const GmpGuard guard(&simulator->deadline());
  simulator->start();
  result.signs_at_start = all_signs(simulator->arithmetic().counters());
  result.failures_at_start = all_failures(simulator->arithmetic().counters());
  const double begin = cpu_seconds();
  result.status = simulator->run_until(std::nullopt);
  result.seconds = cpu_seconds() - begin;
  result.numbers = simulator->arithmetic().counters();
  if (audit_end && result.status == RunStatus::kDone) simulator->audit();
  result.arithmetic = simulator->arithmetic().name();
  const StructureId asked = asked_structure(scene);
  result.ledger = result.costs = simulator->ledger(asked);
  for (StructureId id = 0; id < simulator->structures(); ++id) {
    if (id != asked) add_costs(simulator->ledger(id), result.costs);
  }
  result.run = simulator->ledger();
  // Structures that read one another may use the same predicate: counted under one name.
  std::vector<PredicateCounters> counters;
  for (std::size_t id = 0; id < result.numbers.by_predicate.size(); ++id) {
    const std::string name(simulator->arithmetic().predicate(static_cast<PredicateId>(id)).name());
    const auto known = std::find(result.predicates.begin(), result.predicates.end(), name);
    const auto place = static_cast<std::size_t>(known - result.predicates.begin());
    if (known == result.predicates.end()) {
      result.predicates.push_back(name);
      counters.emplace_back();
    }
    add(result.numbers.by_predicate[id], counters[place]);
  }
  result.numbers.by_predicate = std::move(counters);
  // Includes those of the structures it reads.
  for (std::size_t s = 0; s < simulator->structures(); ++s) {
    const std::vector<BoundCheck> bounds = simulator->bounds(static_cast<StructureId>(s));
    result.bounds.insert(result.bounds.end(), bounds.begin(), bounds.end());
  }
  result.violations = simulator->violations();
  result.attribute = formats::value_now(*simulator, asked);
  return result;
}

}  // namespace kinex::lab
