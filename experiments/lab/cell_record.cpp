// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/cell_record.h"

#include <fmt/format.h>

#include <stdexcept>

#include "experiments/lab/field_archive.h"

namespace kinex {

// Structured bindings name all members: one that is added must be added here too.

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
          retracted_per_event, parts, audit_checks, audit_violations, corrupt, corruption, seconds);
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

template <class Archive>
void fields(Archive& archive, Measurement& value) {
  auto& [arithmetic, scene_name, scene_hash, seed, objects, status, ledger, costs, run, numbers,
         signs_at_start, failures_at_start, predicates, bounds, violations, attribute, started,
         seconds] = value;
  archive(arithmetic, scene_name, scene_hash, seed, objects, status, ledger, costs, run, numbers,
          signs_at_start, failures_at_start, predicates, bounds, violations, attribute, started,
          seconds);
}

template <class Archive>
void fields(Archive& archive, Trial& value) {
  auto& [measurement, witnessed] = value;
  archive(measurement, witnessed);
}

template <class Archive>
void fields(Archive& archive, SpeedContest& value) {
  auto& [rival, ratio, same_counts] = value;
  archive(rival, ratio, same_counts);
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
  archive(trials, contest, seconds);
}

}  // namespace

std::string cell_key(const Cell& cell, const std::optional<int>& seeds) {
  const WorkloadParameters& p = cell.parameters;
  std::string key = fmt::format(
      "{}, {}, n {} m {} seed {} degree {} dimension {} separation {} turns {}{}{}, audit {}, "
      "scenes "
      "{} to {}, at most {} s",
      cell.structure, cell.workload_text(), p.n, p.m, p.seed, p.degree, p.dimension,
      p.separation ? p.separation->to_string() : "-", p.turns, cell.turned ? " turned" : "",
      cell.mirrored ? " mirrored" : "", static_cast<int>(cell.audit), cell.min_seeds,
      cell.max_seeds, cell.max_seconds);
  if (seeds && cell.random) key += fmt::format(", --seeds {}", *seeds);
  for (const Cell::Precise& precise : cell.precise) {
    key += fmt::format(", {} to {}", precise.quantity, precise.relative_error);
  }
  for (const Expectation& expectation : cell.expectations) key += ", " + expectation.claim;
  return key;
}

std::string cell_record(const CellResult& result) {
  return to_fields(Runs{result.trials, result.contest, result.seconds});
}

std::optional<CellResult> read_cell_record(const std::string& record, const Cell& cell) {
  Runs runs;
  try {
    from_fields(record, runs);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
  CellResult result;
  result.cell = cell;
  result.trials = std::move(runs.trials);
  result.contest = std::move(runs.contest);
  result.seconds = runs.seconds;
  return result;
}

std::string study_key(const Study& study) {
  return "study " + study.name + (study.quick ? ", quick" : "");
}

std::string study_record(const StudyResult& result) { return to_fields(result); }

std::optional<StudyResult> read_study_record(const std::string& record) {
  StudyResult result;
  try {
    from_fields(record, result);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
  return result;
}

}  // namespace kinex
