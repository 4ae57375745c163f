// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as JSON lines.
#include "experiments/formats/json_writer.h"
#include "experiments/trade/report.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

void maybe_real(formats::JsonWriter& json, const std::optional<double>& value) {
  if (value) {
    json.real(*value);
  } else {
    json.null();
  }
}

void maybe_text(formats::JsonWriter& json, const std::string& text) {
  if (text.empty()) {
    json.null();
  } else {
    json.string(text);
  }
}

void write_run(formats::JsonWriter& json, const CaseResult& one, const TradeRun& run) {
  const Deviation& deviation = run.deviation;
  json.begin_object().key("arithmetic").string(run.arithmetic);
  json.key("standing").string(standing_name(run.standing()));
  json.key("ending").string(ending_name(run.ending));
  json.key("guard_fired").boolean(run.guard_fired).key("trouble");
  maybe_text(json, run.trouble);
  json.key("events").number(run.events).key("missed").number(deviation.missed);
  json.key("invented").number(deviation.invented).key("inversions").number(deviation.inversions);
  json.key("first_difference");
  if (deviation.first == 0) {
    json.null();
  } else {
    json.begin_object().key("event").number(deviation.first).key("time");
    json.string(deviation.first_time).end_object();
  }
  json.key("error_seconds").real(deviation.error).key("error_ulps").real(deviation.error_ulps);
  json.key("checkpoints").number(run.checkpoints).key("valid").number(run.valid);
  json.key("valid_at_end").boolean(run.valid_at_end).key("first_wrong");
  maybe_text(json, run.first_wrong);
  json.key("violation");
  maybe_text(json, run.violation);
  json.key("seconds");
  maybe_real(json, run.seconds);
  json.key("time_over_double");
  maybe_real(json, one.time_ratio(run));
  json.key("peak_bytes").number(run.peak_bytes).key("memory_over_double");
  maybe_real(json, one.memory_ratio(run));
  json.end_object();
}

void write_mean(formats::JsonWriter& json, const lab::RunningMean& mean) {
  json.begin_object().key("mean").real(mean.mean());
  json.key("standard_error").real(mean.standard_error());
  json.key("smallest").real(mean.smallest()).key("largest").real(mean.largest()).end_object();
}

void write_fit(formats::JsonWriter& json, const std::optional<lab::Fit>& fit) {
  if (!fit) {
    json.null();
    return;
  }
  json.begin_object().key("bits_per_doubling").real(fit->b);
  json.key("interval_95").begin_array().real(fit->lower).real(fit->upper).end_array();
  json.key("factor").real(fit->a).key("chi_square");
  if (fit->weighted) {
    json.real(fit->chi_square);
  } else {
    json.null();
  }
  json.key("degrees_of_freedom").number(fit->degrees).end_object();
}

}  // namespace

std::string json_row(const CaseResult& one) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("row").string("case").key("structure").string(one.which.structure);
  json.key("name").string(one.which.name).key("workload");
  maybe_text(json, one.which.workload);
  json.key("scene").string(one.scene_name).key("scene_hash").string(one.scene_hash);
  json.key("objects").number(static_cast<std::uint64_t>(one.objects));
  json.key("degree").number(one.which.parameters.degree);
  json.key("seed").number(one.which.parameters.seed);
  json.key("events").number(one.events);
  json.key("instants").number(static_cast<std::uint64_t>(one.bits.instants));
  json.key("bits").begin_object();
  json.key("pairs").number(static_cast<std::uint64_t>(one.bits.pairs));
  json.key("most").number(static_cast<std::uint64_t>(one.bits.most));
  json.key("percentile_99").number(static_cast<std::uint64_t>(one.bits.percentile_99));
  json.key("time");
  maybe_text(json, one.bits.time);
  json.end_object().key("runs").begin_array();
  for (const TradeRun& run : one.runs) write_run(json, one, run);
  json.end_array().key("problem");
  maybe_text(json, one.problem);
  json.key("seconds").real(one.seconds).end_object();
  return text + "\n";
}

std::string json_row(const BitsResult& one) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("row").string("bits").key("structure").string(one.which.structure);
  json.key("family").string(one.which.family).key("n").number(one.which.parameters.n);
  json.key("scenes").number(one.which.seeds).key("instants");
  write_mean(json, one.instants);
  json.key("most");
  write_mean(json, one.most);
  json.key("percentile_99");
  write_mean(json, one.percentile_99);
  json.end_object();
  return text + "\n";
}

std::string json_row(const BitsGrowth& growth) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("row").string("growth").key("structure").string(growth.structure);
  json.key("family").string(growth.family).key("most");
  write_fit(json, growth.most);
  json.key("percentile_99");
  write_fit(json, growth.percentile_99);
  json.end_object();
  return text + "\n";
}

}  // namespace kinex::trade
