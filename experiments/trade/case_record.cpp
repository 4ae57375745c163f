// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/case_record.h"

#include <utility>

namespace kinex::trade {

// Structured bindings name all members: one that is added must be added here too.

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
  archive(arithmetic, ending, trouble, guard_fired, events, peak_bytes, deviation, differs,
          checkpoints, valid, valid_at_end, first_wrong, violation);
  archive.times(seconds);
}

namespace {

// Results without `which`, which is known from the key.
struct CaseFields {
  CaseResult result;
};
struct BitsFields {
  BitsResult result;
};

template <class Archive>
void fields(Archive& archive, CaseFields& value) {
  auto& [which, scene_name, scene_hash, objects, events, bits, runs, problem, gave_up, seconds] =
      value.result;
  static_cast<void>(which);
  archive(scene_name, scene_hash, objects, events, bits, runs, problem, gave_up);
  archive.times(seconds);
}

template <class Archive>
void fields(Archive& archive, BitsFields& value) {
  auto& [which, most, percentile_99, instants] = value.result;
  static_cast<void>(which);
  archive(most, percentile_99, instants);
}

}  // namespace

lab::Fields case_fields_of(const CaseResult& result) { return lab::to_fields(CaseFields{result}); }

lab::Fields bits_fields_of(const BitsResult& result) { return lab::to_fields(BitsFields{result}); }

std::optional<CaseResult> case_of(const lab::Fields& fields, const TradeCase& which) {
  std::optional<CaseFields> found = lab::from_fields<CaseFields>(fields);
  if (!found) return std::nullopt;
  found->result.which = which;
  return std::move(found->result);
}

std::optional<BitsResult> bits_of(const lab::Fields& fields, const BitsCase& which) {
  std::optional<BitsFields> found = lab::from_fields<BitsFields>(fields);
  if (!found) return std::nullopt;
  found->result.which = which;
  return std::move(found->result);
}

}  // namespace kinex::trade
