// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/planned.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "core/numbers/show_text.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/scene_run.h"
#include "experiments/sweep/fields_report.h"
#include "experiments/sweep/parameters_json.h"
#include "experiments/trade/case_record.h"

namespace kinex::trade {

namespace {

constexpr const char* kCase = "trade";
constexpr const char* kBits = "bits";
constexpr int kMostScenes = 1000000;

std::uint64_t milliseconds(double seconds) { return static_cast<std::uint64_t>(1000 * seconds); }

TradeCase read_case(const formats::JsonNode& content) {
  content.require_object({"structure", "workload", "n", "seed", "degree", "dimension", "m",
                          "separation", "turns", "arithmetics", "max_seconds", "enough_seconds",
                          "events_factor", "events_more", "seeds"});
  TradeCase one;
  one.structure = content.member("structure").string();
  const formats::JsonNode workload = content.member("workload");
  one.workload = workload.string();
  if (lab::find_workload(one.workload) == nullptr)
    workload.refuse("a workload", "one of kinex gen");
  one.parameters = sweep::read_parameters(content);
  return one;
}

TradeOptions read_limits(const formats::JsonNode& content) {
  TradeOptions options;
  options.max_seconds = content.member("max_seconds").rational().to_double();
  return options;
}

sweep::CellReport run_planned_case(const formats::JsonNode& content) {
  TradeCase which = read_case(content);
  which.enough_seconds = content.member("enough_seconds").rational().to_double();
  TradeOptions options = read_limits(content);
  const formats::JsonNode arithmetics = content.member("arithmetics");
  arithmetics.require_array();
  options.arithmetics.clear();
  for (std::size_t i = 0; i < arithmetics.size(); ++i) {
    options.arithmetics.emplace_back(arithmetics.at(i).string());
  }
  return report_of(run_case(which, options).value());
}

sweep::CellReport run_planned_bits(const formats::JsonNode& content) {
  const TradeCase one = read_case(content);
  BitsCase which;
  which.structure = one.structure;
  which.workload = one.workload;
  which.parameters = one.parameters;
  which.seeds = content.member("seeds").integer(1, kMostScenes);
  return report_of(run_bits(which, read_limits(content)));
}

double seconds_option(const std::string& text) {
  double seconds = 0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result read = std::from_chars(text.data(), end, seconds);
  if (read.ec == std::errc() && read.ptr == end && std::isfinite(seconds) && seconds > 0)
    return seconds;
  throw formats::InputError("--max-seconds", "", show_text(text) + " is no number of seconds",
                            "write a number above 0");
}

// Throws InputError for other options.
TradeOptions options_of(const sweep::Selection& selection) {
  TradeOptions options;
  for (const auto& [option, values] : selection.options) {
    if (option == "arithmetic") {
      const Scene nothing;
      for (const std::string& name : values) lab::arithmetic_option(name, nothing);
      options.arithmetics = values;
    } else if (option == "max-seconds" && values.size() == 1) {
      options.max_seconds = seconds_option(values.front());
    } else {
      throw formats::InputError("--" + option, "", "trade has no such option", "leave it out");
    }
  }
  return options;
}

std::vector<sweep::PlanCell> cells_of(const sweep::Selection& selection) {
  const TradeOptions options = options_of(selection);
  const TradeCatalogue catalogue = make_trade_catalogue(
      selection.names, selection.quick ? lab::Extent::kQuick : lab::Extent::kFull);
  std::vector<sweep::PlanCell> cells;
  for (const TradeCase& which : catalogue.cases) {
    if (which.given != nullptr) {
      throw formats::InputError(which.name, "", "a scene of a file is of no plan",
                                "name a structure, or run the scene with kinex trade");
    }
    cells.push_back(planned(which, options));
  }
  for (const BitsCase& which : catalogue.bits) cells.push_back(planned(which, options));
  return cells;
}

std::string seconds_text(double seconds) {
  std::string text;
  formats::JsonWriter(text).real(seconds);
  return text;
}

std::string reason(const sweep::Record& record) {
  return std::string(sweep::outcome_name(record.outcome)) +
         (record.message.empty() ? "" : ": " + record.message);
}

}  // namespace

sweep::PlanCell planned(const TradeCase& which, const TradeOptions& options) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key(kCase).begin_object().key("structure").string(which.structure);
  if (which.given != nullptr) {
    json.key("scene_hash").string(formats::scene_hash(*which.given));
  } else {
    json.key("workload").string(which.workload);
    sweep::write_parameters(json, which.parameters);
  }
  json.key("arithmetics").begin_array();
  for (const std::string& arithmetic : options.arithmetics) json.string(arithmetic);
  json.end_array().key("max_seconds").real(options.max_seconds);
  json.key("enough_seconds").real(which.enough_seconds);
  json.key("events_factor").number(options.events_factor);
  json.key("events_more").number(options.events_more).end_object().end_object();
  return sweep::make_cell(which.structure, text, milliseconds(which.cost));
}

sweep::PlanCell planned(const BitsCase& which, const TradeOptions& options) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key(kBits).begin_object().key("structure").string(which.structure);
  json.key("workload").string(which.workload);
  sweep::write_parameters(json, which.parameters);
  json.key("seeds").number(which.seeds).key("max_seconds").real(options.max_seconds);
  json.end_object().end_object();
  return sweep::make_cell("bits " + which.structure, text, milliseconds(which.cost));
}

sweep::CellReport report_of(const CaseResult& result) {
  const std::vector<std::string> faults = result.faults();
  bool gave_up = result.gave_up;
  for (const TradeRun& run : result.runs) gave_up = gave_up || run.ending == Ending::kGaveUp;
  const sweep::Outcome outcome = !faults.empty() ? sweep::Outcome::kFailed
                                 : gave_up       ? sweep::Outcome::kLimit
                                                 : sweep::Outcome::kDone;
  return sweep::report_of(outcome, faults.empty() ? "" : faults.front(), case_fields_of(result));
}

sweep::CellReport report_of(const std::optional<BitsResult>& result) {
  if (result) return sweep::report_of(sweep::Outcome::kDone, "", bits_fields_of(*result));
  sweep::CellReport report;
  report.outcome = sweep::Outcome::kLimit;
  report.message = "the exact run takes too long";
  return report;
}

CaseResult result_of(const sweep::Record& record, const TradeCase& which) {
  if (const auto fields = sweep::fields_of(record)) {
    if (auto result = case_of(*fields, which)) return *std::move(result);
  }
  CaseResult result;
  result.which = which;
  result.problem = reason(record);
  result.gave_up =
      record.outcome == sweep::Outcome::kLimit || record.outcome == sweep::Outcome::kMemory;
  return result;
}

BitsResult result_of(const sweep::Record& record, const BitsCase& which) {
  if (const auto fields = sweep::fields_of(record)) {
    if (auto result = bits_of(*fields, which)) return *std::move(result);
  }
  BitsResult result;
  result.which = which;
  return result;
}

sweep::Selection selection_of(const std::vector<std::string>& what, bool quick,
                              const TradeOptions& options) {
  const TradeOptions usual;
  sweep::Selection selection;
  selection.experiment = "trade";
  selection.names = what;
  selection.quick = quick;
  if (options.arithmetics != usual.arithmetics)
    selection.options["arithmetic"] = options.arithmetics;
  if (options.max_seconds != usual.max_seconds) {
    selection.options["max-seconds"] = {seconds_text(options.max_seconds)};
  }
  return selection;
}

void add_experiment(sweep::Experiments& experiments) {
  experiments.all.push_back(
      {"trade", "what does a less exact arithmetic trade for its speed? [STRUCTURE ..]", cells_of});
  experiments.kinds.push_back({kCase, run_planned_case});
  experiments.kinds.push_back({kBits, run_planned_bits});
}

}  // namespace kinex::trade
