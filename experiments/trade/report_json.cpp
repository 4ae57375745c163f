// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as JSON lines.
#include "experiments/lab/report_json.h"
#include "experiments/trade/report_text.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

void write_run(formats::JsonWriter& json, const CaseResult& one, const TradeRun& run) {
  const Deviation& deviation = run.deviation;
  json.begin_object().members("arithmetic", run.arithmetic, "standing", standing_name(run.standing()),
                              "ending", ending_name(run.ending), "guard_fired", run.guard_fired,
                              "trouble", lab::unless_empty(run.trouble), "events", run.events, "missed",
                              deviation.missed, "invented", deviation.invented, "inversions",
                              deviation.inversions);
  json.key("first_difference");
  if (deviation.first == 0) {
    json.null();
  } else {
    json.object("event", deviation.first, "time", time_decimal(deviation.first_time));
  }
  json.members("error_seconds", deviation.error, "error_ulps", deviation.error_ulps, "checkpoints",
               run.checkpoints, "valid", run.valid, "valid_at_end", run.valid_at_end, "first_wrong",
               time_decimal(run.first_wrong), "violation", lab::unless_empty(run.violation), "seconds",
               run.seconds, "time_over_double", one.time_ratio(run), "peak_bytes", run.peak_bytes,
               "memory_over_double", one.memory_ratio(run));
  json.end_object();
}

void write_fit(formats::JsonWriter& json, const char* name, const std::optional<lab::Fit>& fit) {
  json.key(name);
  if (!fit) {
    json.null();
    return;
  }
  json.object("bits_per_doubling", fit->b, "interval_95", std::vector{fit->lower, fit->upper}, "factor",
              fit->a, "chi_square", lab::chi_square_of(*fit), "degrees_of_freedom", fit->degrees);
}

}  // namespace

std::string json_row(const CaseResult& one) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().members("row", "case", "structure", one.which.structure, "name", one.which.name,
                              "workload", lab::unless_empty(one.which.workload), "scene", one.scene_name,
                              "scene_hash", one.scene_hash, "objects", one.objects, "degree",
                              one.which.parameters.degree, "seed", one.which.parameters.seed, "events",
                              one.events, "instants", one.bits.instants);
  json.key("bits").object("pairs", one.bits.pairs, "most", one.bits.most, "percentile_99",
                          one.bits.percentile_99, "time", time_decimal(one.bits.time));
  json.key("runs").begin_array();
  for (const TradeRun& run : one.runs) write_run(json, one, run);
  json.end_array().members("problem", lab::unless_empty(one.problem), "seconds", one.seconds);
  json.end_object();
  return text + "\n";
}

std::string json_row(const BitsResult& one) {
  std::string text;
  formats::JsonWriter(text).object("row", "bits", "structure", one.which.structure, "family",
                                   one.which.family, "n", one.which.parameters.n, "scenes",
                                   one.which.seeds, "instants", one.instants, "most", one.most,
                                   "percentile_99", one.percentile_99);
  return text + "\n";
}

std::string json_row(const BitsGrowth& growth) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().members("row", "growth", "structure", growth.structure, "family", growth.family);
  write_fit(json, "most", growth.most);
  write_fit(json, "percentile_99", growth.percentile_99);
  json.end_object();
  return text + "\n";
}

}  // namespace kinex::trade
