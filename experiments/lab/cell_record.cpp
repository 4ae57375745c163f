// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/cell_record.h"

#include <utility>

// Structured bindings name all members: one that is added must be added here too.

// Of the engine's records: the archive finds them by the namespace of their argument.
namespace kinex {

template <class Archive>
void fields(Archive& archive, PredicateCounters& value) {
  auto& [signs, failures, looks, comparisons] = value;
  archive(signs, failures, looks, comparisons);
}

template <class Archive>
void fields(Archive& archive, ArithmeticCounters& value) {
  auto& [by_predicate, comparisons, solved, made_exact, refinements, gcds, bits] = value;
  archive(by_predicate, comparisons, solved, made_exact, refinements, gcds, bits);
}

template <class Archive>
void fields(Archive& archive, ChangeStatistics& value) {
  auto& [events, total, max, histogram] = value;
  archive(events, total, max, histogram);
}

template <class Archive>
void fields(Archive& archive, PartLedger& value) {
  auto& [name, failures, created, retracted, live, max_live] = value;
  archive(name, failures, created, retracted, live, max_live);
}

template <class Archive>
void fields(Archive& archive, StructureLedger& value) {
  auto& [processed, external, internal, failures, records, rebuilds, rebuild_reasons, groups,
         largest_group, by_kind, motion_updates, insertions, erasures, created, retracted, live,
         max_live, max_per_object, failures_found, failures_unused, windows, created_per_event,
         retracted_per_event, parts, audit_checks, audit_violations, corrupt, corruption, seconds] =
      value;
  archive(processed, external, internal, failures, records, rebuilds, rebuild_reasons, groups,
          largest_group, by_kind, motion_updates, insertions, erasures, created, retracted, live,
          max_live, max_per_object, failures_found, failures_unused, windows, created_per_event,
          retracted_per_event, parts, audit_checks, audit_violations, corrupt, corruption);
  archive.times(seconds);
}

template <class Archive>
void fields(Archive& archive, RunLedger& value) {
  auto& [max_queue, events, instants, peak_bytes] = value;
  archive(max_queue, events, instants, peak_bytes);
}

template <class Archive>
void fields(Archive& archive, BoundCheck& value) {
  auto& [id, source, bound, observed, holds] = value;
  archive(id, source, bound, observed, holds);
}

template <class Archive>
void fields(Archive& archive, Attribute& value) {
  auto& [shape, ids, width] = value;
  archive(shape, ids, width);
}

}  // namespace kinex

namespace kinex::lab {

template <class Archive>
void fields(Archive& archive, Measurement& value) {
  auto& [arithmetic, scene_name, scene_hash, seed, objects, status, ledger, costs, run, numbers,
         signs_at_start, failures_at_start, predicates, bounds, violations, attribute, started,
         seconds] = value;
  archive(arithmetic, scene_name, scene_hash, seed, objects, status, ledger, costs, run, numbers,
          signs_at_start, failures_at_start, predicates, bounds, violations, attribute);
  archive.times(started, seconds);
}

template <class Archive>
void fields(Archive& archive, Trial& value) {
  auto& [measurement, witnessed] = value;
  archive(measurement, witnessed);
}

template <class Archive>
void fields(Archive& archive, SpeedContest& value) {
  auto& [rival, ratio, same_counts] = value;
  archive(rival, same_counts);
  archive.times(ratio);
}

template <class Archive>
void fields(Archive& archive, Check& value) {
  auto& [claim, kind, quantity, expected, observed, source, verdict, trial, seeds_needed] = value;
  archive(claim, kind, quantity, expected, observed, source, verdict, trial, seeds_needed);
}

template <class Archive>
void fields(Archive& archive, StudyResult& value) {
  auto& [name, table, checks] = value;
  archive(name, table.title, table.header, table.rows, table.note, checks);
}

namespace {

struct Runs {
  std::vector<Trial> trials;
  std::optional<SpeedContest> contest;
  double seconds = 0;
};

template <class Archive>
void fields(Archive& archive, Runs& value) {
  auto& [trials, contest, seconds] = value;
  archive(trials, contest);
  archive.times(seconds);
}

}  // namespace

Fields cell_fields(const CellResult& result) {
  return to_fields(Runs{result.trials, result.contest, result.seconds});
}

std::optional<CellResult> cell_of(const Fields& fields, const Cell& cell) {
  std::optional<Runs> runs = from_fields<Runs>(fields);
  if (!runs) return std::nullopt;
  CellResult result;
  result.cell = cell;
  result.trials = std::move(runs->trials);
  result.contest = std::move(runs->contest);
  result.seconds = runs->seconds;
  return result;
}

Fields study_fields(const StudyResult& result) { return to_fields(result); }

std::optional<StudyResult> study_of(const Fields& fields) {
  return from_fields<StudyResult>(fields);
}

}  // namespace kinex::lab
