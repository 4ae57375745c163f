// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/database.h"

#include "experiments/lab/judge.h"
#include "experiments/lab/result_database.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

constexpr int kDigits = 6;

// `value`, or NULL unless `there`.
template <class Value>
std::optional<Value> if_there(bool there, const Value& value) {
  return there ? std::optional(value) : std::nullopt;
}

void write(lab::ResultDatabase& database, const CaseResult& one) {
  const BitsNeeded& bits = one.bits;
  const bool any = bits.pairs > 0;
  const lab::WorkloadParameters& parameters = one.which.parameters;
  const std::int64_t id = database.insert(
      "trade_case", nullptr, 1, 1, one.which.structure, one.which.name, one.scene_name, one.scene_hash,
      one.objects, parameters.degree, parameters.seed, one.events, bits.instants,
      if_there(any, bits.most), if_there(any, bits.percentile_99), time_decimal(bits.time),
      lab::unless_empty(one.problem), one.seconds);
  for (const TradeRun& run : one.runs) {
    const Deviation& deviation = run.deviation;
    database.insert(
        "trade_run", id, run.arithmetic, standing_name(run.standing()), ending_name(run.ending),
        lab::unless_empty(run.trouble), run.guard_fired, run.seconds,
        lab::number_text(one.time_ratio(run), kDigits), run.peak_bytes,
        lab::number_text(one.memory_ratio(run), kDigits), run.events, deviation.missed,
        deviation.invented, deviation.inversions, if_there(deviation.first > 0, deviation.first),
        time_decimal(deviation.first_time), deviation.error,
        lab::number_text(deviation.error_ulps, kDigits), run.checkpoints, run.valid, run.valid_at_end,
        time_decimal(run.first_wrong), lab::unless_empty(run.violation));
  }
}

void write(lab::ResultDatabase& database, const BitsResult& one) {
  const auto text = [](double value) { return lab::number_text(value, kDigits); };
  database.insert("bits", one.which.structure, one.which.family, one.which.parameters.n,
                  one.which.seeds, text(one.instants.mean()), text(one.most.mean()),
                  text(one.most.standard_error()), text(one.most.largest()),
                  text(one.percentile_99.mean()), text(one.percentile_99.standard_error()));
}

void write(lab::ResultDatabase& database, const BitsGrowth& growth) {
  const auto add = [&](const char* quantity, const std::optional<lab::Fit>& fit) {
    if (!fit) return;
    database.insert("bits_growth", growth.structure, growth.family, quantity,
                    lab::number_text(fit->b, kDigits), lab::number_text(fit->lower, kDigits),
                    lab::number_text(fit->upper, kDigits), lab::number_text(fit->a, kDigits));
  };
  add("most", growth.most);
  add("percentile_99", growth.percentile_99);
}

}  // namespace

std::string trade_database(const TradeResult& result, const lab::BuildFacts& build,
                           const lab::MachineFacts& machine) {
  lab::ResultDatabase database(lab::trade_schema());
  database.insert_facts(build, machine);
  for (const CaseResult& one : result.cases) write(database, one);
  for (const BitsResult& one : result.bits) write(database, one);
  for (const BitsGrowth& growth : result.growths) write(database, growth);
  return database.bytes();
}

}  // namespace kinex::trade
