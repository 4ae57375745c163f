// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/case_record.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "experiments/formats/scene_writer.h"
#include "experiments/lab/field_archive.h"

namespace kinex {

// Structured bindings name all members: one that is added must be added here too.

template <class Archive>
void fields(Archive& archive, RunningMean& value) {
  value.fields(archive);
}

template <class Archive>
void fields(Archive& archive, BitsNeeded& value) {
  auto& [instants, pairs, most, percentile_99, time] = value;
  archive(instants, pairs, most, percentile_99, time);
}

template <class Archive>
void fields(Archive& archive, Deviation& value) {
  auto& [missed, invented, inversions, first, first_time, error, error_ulps, matched] = value;
  archive(missed, invented, inversions, first, first_time, error, error_ulps, matched);
}

template <class Archive>
void fields(Archive& archive, TradeRun& value) {
  auto& [arithmetic, ending, trouble, guard_fired, events, seconds, peak_bytes, deviation, differs,
         checkpoints, valid, valid_at_end, first_wrong, violation] = value;
  archive(arithmetic, ending, trouble, guard_fired, events, seconds, peak_bytes, deviation, differs,
          checkpoints, valid, valid_at_end, first_wrong, violation);
}

namespace {

// `which` is known from the key.
template <class Archive>
void case_fields(Archive& archive, CaseResult& value) {
  auto& [which, scene_name, scene_hash, objects, events, bits, runs, problem, gave_up, seconds] =
      value;
  static_cast<void>(which);
  archive(scene_name, scene_hash, objects, events, bits, runs, problem, gave_up, seconds);
}

template <class Archive>
void bits_fields(Archive& archive, BitsResult& value) {
  auto& [which, most, percentile_99, instants] = value;
  static_cast<void>(which);
  archive(most, percentile_99, instants);
}

std::string parameters_text(const WorkloadParameters& p) {
  return fmt::format("n {} m {} seed {} degree {} dimension {} separation {} turns {}", p.n, p.m,
                     p.seed, p.degree, p.dimension, p.separation ? p.separation->to_string() : "-",
                     p.turns);
}

}  // namespace

std::string case_key(const TradeCase& which, const TradeOptions& options) {
  std::string key = fmt::format("{}, {}, {} {}, at most {} s and {} x + {} events", which.structure,
                                which.name, which.workload, parameters_text(which.parameters),
                                options.max_seconds, options.events_factor, options.events_more);
  if (which.given != nullptr) key += ", scene " + scene_hash(*which.given);
  for (const std::string& arithmetic : options.arithmetics) key += ", " + arithmetic;
  return key;
}

std::string bits_key(const BitsCase& which) {
  return fmt::format("bits, {}, {} {}, scenes {}, {}", which.structure, which.workload,
                     parameters_text(which.parameters), which.seeds, which.family);
}

std::string case_record(const CaseResult& result) {
  FieldWriter writer;
  CaseResult copy = result;
  case_fields(writer, copy);
  return std::move(writer.text);
}

std::string bits_record(const BitsResult& result) {
  FieldWriter writer;
  BitsResult copy = result;
  bits_fields(writer, copy);
  return std::move(writer.text);
}

std::optional<CaseResult> read_case_record(const std::string& record, const TradeCase& which) {
  CaseResult result;
  result.which = which;
  try {
    FieldReader reader(record);
    case_fields(reader, result);
    if (reader.at_end()) return result;
  } catch (const std::runtime_error&) {
  }
  return std::nullopt;
}

std::optional<BitsResult> read_bits_record(const std::string& record, const BitsCase& which) {
  BitsResult result;
  result.which = which;
  try {
    FieldReader reader(record);
    bits_fields(reader, result);
    if (reader.at_end()) return result;
  } catch (const std::runtime_error&) {
  }
  return std::nullopt;
}

}  // namespace kinex
