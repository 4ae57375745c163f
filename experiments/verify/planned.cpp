// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/planned.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/lab/cell_record.h"
#include "experiments/sweep/fields_report.h"
#include "experiments/sweep/parameters_json.h"
#include "experiments/verify/catalogue.h"
#include "experiments/verify/runner.h"
#include "structures/registry.h"

namespace kinex::verify {

namespace {

constexpr const char* kCell = "verify";
constexpr const char* kStudy = "study";
constexpr int kMostSeeds = 1000000;
constexpr double kStudyCost = 60;  // seconds; rarely known before

std::uint64_t milliseconds(double seconds) { return static_cast<std::uint64_t>(1000 * seconds); }

constexpr const char* audit_word(AuditLevel audit) {
  return audit == AuditLevel::kNone ? "none" : audit == AuditLevel::kEnd ? "end" : "events";
}

std::string cell_json(const lab::Cell& cell, const std::optional<int>& seeds) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key(kCell).begin_object().key("structure").string(cell.structure);
  json.key("workload").string(cell.workload);
  sweep::write_parameters(json, cell.parameters);
  if (cell.change != nullptr) json.key(cell.change->name).boolean(true);
  if (cell.mirrored) json.key("mirrored").boolean(true);
  json.key("audit").string(audit_word(cell.audit)).key("max_seconds").real(cell.max_seconds);
  json.key("min_seeds").number(cell.min_seeds).key("max_seeds").number(cell.max_seeds);
  if (seeds && cell.random) json.key("seeds").number(*seeds);
  json.key("precise").begin_array();
  for (const lab::Cell::Precise& precise : cell.precise) {
    json.begin_object().key("quantity").string(precise.quantity);
    json.key("error").real(precise.relative_error).end_object();
  }
  json.end_array().key("witnesses").begin_array();  // of every expectation, for their places
  for (const lab::Expectation& expectation : cell.expectations) {
    const bool witness = expectation.kind == lab::ExpectationKind::kWitness;
    json.string(witness ? expectation.claim : "");
  }
  json.end_array().end_object().end_object();
  return text;
}

[[noreturn]] void fail_unknown(const formats::JsonNode& content) {
  content.fail("no experiment of this program has such a cell",
               "give a cell as `kinex sweep list verify` prints it");
}

sweep::CellReport run_planned_cell(const formats::JsonNode& content) {
  const std::string text =
      std::string("{\"") + kCell + "\":" + formats::canonical_json(content.value()) + "}";
  VerifyOptions options;
  if (const auto seeds = content.find("seeds")) options.seeds = seeds->integer(1, kMostSeeds);
  const std::string structure(content.member("structure").string());
  if (find_structure_info(structure) == nullptr) fail_unknown(content);
  for (const lab::Extent extent : {lab::Extent::kQuick, lab::Extent::kFull}) {
    for (const lab::Cell& cell : make_catalogue(structure, extent).cells) {
      if (planned(cell, options.seeds).text != text) continue;
      return report_of(run_trials(cell, options).value());
    }
  }
  fail_unknown(content);
}

sweep::CellReport run_planned_study(const formats::JsonNode& content) {
  content.require_object({"name", "quick"});
  const lab::Extent extent =
      content.member("quick").boolean() ? lab::Extent::kQuick : lab::Extent::kFull;
  for (const lab::Study& study : make_catalogue("all", extent).studies) {
    if (study.name != content.member("name").string()) continue;
    return report_of(study.run(study.quick, [] { return true; }));
  }
  fail_unknown(content);
}

std::optional<int> seeds_of(const sweep::Selection& selection) {
  const auto found = selection.options.find("seeds");
  if (found == selection.options.end()) return std::nullopt;
  int seeds = 0;
  const std::string text = found->second.size() == 1 ? found->second.front() : "";
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), seeds);
  if (error != std::errc() || rest != text.data() + text.size() || seeds < 1 ||
      seeds > kMostSeeds) {
    throw formats::InputError("--seeds", "", show_text(text) + " is no number of scenes",
                              "write a number from 1 to " + std::to_string(kMostSeeds));
  }
  return seeds;
}

std::vector<sweep::PlanCell> cells_of(const sweep::Selection& selection) {
  for (const auto& [option, values] : selection.options) {
    if (option == "seeds") continue;
    throw formats::InputError("--" + option, "", "verify has no such option", "leave it out");
  }
  if (selection.names.size() > 1) {
    throw formats::InputError("verify", "", "more than one structure", "give one, a group, a family, or all");
  }
  const std::optional<int> seeds = seeds_of(selection);
  const lab::Catalogue catalogue =
      make_catalogue(selection.names.empty() ? "all" : selection.names.front(),
                     selection.quick ? lab::Extent::kQuick : lab::Extent::kFull);
  std::vector<sweep::PlanCell> cells;
  for (const lab::Cell& cell : catalogue.cells) cells.push_back(planned(cell, seeds));
  for (const lab::Study& study : catalogue.studies) cells.push_back(planned(study));
  return cells;
}

// Why a record has no runs.
lab::Check no_runs(const sweep::Record& record) {
  lab::Check check{kThrew,      "run", "", "runs to the end", "", "", lab::Verdict::kRefuted,
                   std::nullopt};
  check.observed = std::string(sweep::outcome_name(record.outcome)) +
                   (record.message.empty() ? "" : ": " + record.message);
  if (record.outcome == sweep::Outcome::kLimit || record.outcome == sweep::Outcome::kMemory) {
    check.verdict = lab::Verdict::kGaveUp;
  }
  return check;
}

}  // namespace

sweep::PlanCell planned(const lab::Cell& cell, const std::optional<int>& seeds) {
  return sweep::make_cell(cell.structure, cell_json(cell, seeds), milliseconds(cell.cost));
}

sweep::PlanCell planned(const lab::Study& study) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key(kStudy).begin_object().key("name").string(study.name);
  json.key("quick").boolean(study.quick).end_object().end_object();
  return sweep::make_cell("study " + study.name, text, milliseconds(kStudyCost));
}

sweep::CellReport report_of(const lab::CellResult& result) {
  sweep::Outcome outcome = sweep::Outcome::kDone;
  std::string message;
  double simulated = 0;
  for (const lab::Trial& trial : result.trials) {
    const lab::Measurement& run = trial.measurement;
    simulated += run.seconds;
    const auto broken = std::find_if(run.bounds.begin(), run.bounds.end(),
                                     [](const BoundCheck& bound) { return !bound.holds; });
    if (outcome == sweep::Outcome::kDone && (broken != run.bounds.end() || !run.clean())) {
      outcome = sweep::Outcome::kFailed;
      message = broken != run.bounds.end() ? "bound " + broken->id
                : run.violations.empty()   ? run.ledger.corruption
                                           : run.violations.front();
    }
  }
  const bool gave_up = std::any_of(
      result.trials.begin(), result.trials.end(),
      [](const lab::Trial& trial) { return trial.measurement.status != RunStatus::kDone; });
  if (gave_up && outcome == sweep::Outcome::kDone) outcome = sweep::Outcome::kLimit;
  sweep::CellReport report =
      sweep::report_of(outcome, std::move(message), lab::cell_fields(result));
  report.simulate_s = simulated;
  return report;
}

sweep::CellReport report_of(const lab::StudyResult& result) {
  return sweep::report_of(sweep::Outcome::kDone, "", lab::study_fields(result));
}

lab::CellResult result_of(const sweep::Record& record, const lab::Cell& cell) {
  if (const auto fields = sweep::fields_of(record)) {
    if (auto result = lab::cell_of(*fields, cell)) return *std::move(result);
  }
  lab::CellResult result;
  result.cell = cell;
  result.checks.push_back(no_runs(record));
  return result;
}

lab::StudyResult study_of(const sweep::Record& record, const lab::Study& study) {
  if (const auto fields = sweep::fields_of(record)) {
    if (auto result = lab::study_of(*fields)) return *std::move(result);
  }
  lab::StudyResult result;
  result.name = study.name;
  result.checks.push_back(no_runs(record));
  return result;
}

sweep::Selection selection_of(const std::string& structure, bool quick,
                              const std::optional<int>& seeds) {
  sweep::Selection selection;
  selection.experiment = "verify";
  if (structure != "all") selection.names = {structure};
  selection.quick = quick;
  if (seeds) selection.options["seeds"] = {std::to_string(*seeds)};
  return selection;
}

void add_experiment(sweep::Experiments& experiments) {
  experiments.all.push_back(
      {"verify", "do the structures do what their theory says? [STRUCTURE] [--seeds N]", cells_of});
  experiments.kinds.push_back({kCell, run_planned_cell});
  experiments.kinds.push_back({kStudy, run_planned_study});
}

}  // namespace kinex::verify
