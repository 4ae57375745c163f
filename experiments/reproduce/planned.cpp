// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproduce/planned.h"

#include <optional>
#include <utility>

#include "core/numbers/near_names.h"
#include "experiments/formats/canonical_json.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/lab/cell_record.h"
#include "experiments/reproduce/papers.h"
#include "experiments/sweep/fields_report.h"

namespace kinex::reproduce {

namespace {

constexpr const char* kSeries = "series";
constexpr const char* kStudy = "paper_study";
constexpr const char* kCheck = "checked";
constexpr double kStudyCost = 60;  // seconds; rarely known before

std::uint64_t milliseconds(double seconds) { return static_cast<std::uint64_t>(1000 * seconds); }

std::string series_json(const lab::SeriesPoint& point) {
  const lab::RunKey& key = point.key;
  std::string text;
  formats::JsonWriter json(text);
  const lab::WorkloadParameters& parameters = key.parameters;
  json.begin_object().key(kSeries).begin_object();
  json.members("structure", key.structure, "workload", key.workload, "n", parameters.n, "dimension",
               parameters.dimension);
  if (key.forever) json.members("forever", true);
  if (key.max_events != 0) json.members("max_events", key.max_events);
  if (parameters.m != 0) json.members("m", parameters.m);
  if (parameters.separation) json.members("separation", parameters.separation->to_string());
  if (parameters.turns != -1) json.members("turns", parameters.turns);
  if (key.change != nullptr) json.members(key.change->name, true);
  json.key("precise").string(point.precise).key("error").real(point.relative_error);
  json.key("min_seeds").number(point.min_seeds).key("max_seeds").number(point.max_seeds);
  json.end_object().end_object();
  return text;
}

[[noreturn]] void fail_unknown(const formats::JsonNode& content) {
  content.fail("no paper of this program has such a cell",
               "give a cell as `kinex sweep list reproduce PAPER` prints it");
}

sweep::CellReport run_series(const formats::JsonNode& content) {
  const std::string text =
      std::string("{\"") + kSeries + "\":" + formats::canonical_json(content.value()) + "}";
  for (const lab::Paper& paper : papers()) {
    for (const lab::PaperPart& part : paper.parts) {
      for (const bool quick : {true, false}) {
        for (const lab::SeriesPoint& point : part.points(quick)) {
          if (planned(point).text == text) return report_of(lab::run_point(point, {}).value());
        }
      }
    }
  }
  fail_unknown(content);
}

sweep::CellReport run_study(const formats::JsonNode& content) {
  content.require_object({"part", "quick"});
  for (const lab::Paper& paper : papers()) {
    for (const lab::PaperPart& part : paper.parts) {
      if (part.study == nullptr || part.name != content.member("part").string()) continue;
      return report_of(part.study(content.member("quick").boolean(), [] { return true; }));
    }
  }
  fail_unknown(content);
}

std::vector<sweep::PlanCell> cells_of(const sweep::Selection& selection) {
  if (!selection.options.empty()) {
    throw formats::InputError("--" + selection.options.begin()->first, "",
                              "reproduce has no such option", "leave it out");
  }
  const lab::Paper& paper = paper_named(selection.names.empty() ? "" : selection.names.front());
  std::vector<std::string> parts = selection.names;
  parts.erase(parts.begin());
  std::vector<sweep::PlanCell> cells;
  for (const lab::PaperPart* part : parts_named(paper, parts)) {
    for (const lab::SeriesPoint& point : part->points(selection.quick)) {
      cells.push_back(planned(point));
    }
    if (part->study != nullptr) cells.push_back(planned_study(*part, selection.quick));
  }
  return cells;
}

// The problem of a record without a result.
std::string no_result(const sweep::Record& record) {
  return record.cell + ": " + std::string(sweep::outcome_name(record.outcome)) +
         (record.message.empty() ? "" : ": " + record.message);
}

}  // namespace

const lab::Paper& paper_named(const std::string& name) {
  std::string names;
  std::vector<std::string> known;
  for (const lab::Paper& paper : papers()) {
    if (paper.name == name) return paper;
    known.emplace_back(paper.name);
    names += (names.empty() ? "" : ", ") + std::string(paper.name);
  }
  throw formats::InputError(
      "PAPER", "", name.empty() ? "there is none" : show_text(name) + ": there is no such paper",
      did_you_mean(name, known, "write " + names));
}

std::vector<const lab::PaperPart*> parts_named(const lab::Paper& paper,
                                               const std::vector<std::string>& names) {
  std::vector<const lab::PaperPart*> parts;
  std::string known;
  std::vector<std::string> part_names;
  for (const lab::PaperPart& part : paper.parts) {
    part_names.emplace_back(part.name);
    known += (known.empty() ? "" : ", ") + std::string(part.name);
    if (names.empty()) parts.push_back(&part);
  }
  for (const std::string& name : names) {
    const std::size_t before = parts.size();
    for (const lab::PaperPart& part : paper.parts) {
      if (part.name == name) parts.push_back(&part);
    }
    if (parts.size() == before) {
      throw formats::InputError(
          "PART", "", show_text(name) + ": the paper has no such part",
          did_you_mean(name, part_names, "write " + known + ", or nothing for all of them"));
    }
  }
  return parts;
}

sweep::PlanCell planned(const lab::SeriesPoint& point) {
  return sweep::make_cell(point.key.structure, series_json(point), milliseconds(point.cost));
}

sweep::PlanCell planned_study(const lab::PaperPart& part, bool quick) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key(kStudy).begin_object().key("part").string(part.name);
  json.key("quick").boolean(quick).end_object().end_object();
  return sweep::make_cell("study " + std::string(part.name), text, milliseconds(kStudyCost));
}

sweep::PlanCell planned_check(const lab::RunKey& run, std::string_view program) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key(kCheck).begin_object().key("program").string(program);
  json.key("run").string(run.text()).end_object().end_object();
  return sweep::make_cell("check", text, 1);
}

sweep::CellReport report_of(const lab::SeriesResult& result) {
  sweep::Outcome outcome = sweep::Outcome::kDone;
  std::string message;
  double simulated = 0;
  for (const lab::RunRecord& run : result.runs) {
    simulated += run.seconds;
    if (run.clean || outcome != sweep::Outcome::kDone) continue;
    outcome = sweep::Outcome::kFailed;
    message = run.key + ": " + run.trouble;
  }
  sweep::CellReport report =
      sweep::report_of(outcome, std::move(message), lab::runs_fields(result.runs));
  report.simulate_s = simulated;
  return report;
}

sweep::CellReport report_of(const lab::StudyResult& result) {
  return sweep::report_of(sweep::Outcome::kDone, "", lab::study_fields(result));
}

sweep::CellReport report_of(const lab::CheckedBy& checked) {
  return sweep::report_of(sweep::Outcome::kDone, "", lab::check_fields(checked));
}

lab::SeriesResult series_of(const sweep::Record& record, const lab::SeriesPoint& point,
                            std::string& trouble) {
  lab::SeriesResult result;
  result.point = point;
  if (const auto fields = sweep::fields_of(record)) {
    if (auto runs = lab::runs_of(*fields)) result.runs = *std::move(runs);
  }
  if (result.runs.empty()) trouble = no_result(record);
  return result;
}

lab::StudyResult study_of(const sweep::Record& record, std::string& trouble) {
  if (const auto fields = sweep::fields_of(record)) {
    if (auto result = lab::study_of(*fields)) return *std::move(result);
  }
  trouble = no_result(record);
  return {};
}

lab::CheckedBy check_of(const sweep::Record& record, const lab::RunKey& run) {
  lab::CheckedBy checked;
  if (const auto fields = sweep::fields_of(record)) {
    if (auto stored = lab::check_of(*fields)) checked = *std::move(stored);
  }
  checked.run = run;
  return checked;
}

sweep::Selection selection_of(const std::string& paper, const std::vector<std::string>& parts,
                              bool quick) {
  sweep::Selection selection;
  selection.experiment = "reproduce";
  selection.names.push_back(paper);
  selection.names.insert(selection.names.end(), parts.begin(), parts.end());
  selection.quick = quick;
  return selection;
}

void add_experiment(sweep::Experiments& experiments) {
  experiments.all.push_back({"reproduce", "the runs of a paper's figures and claims", cells_of});
  experiments.kinds.push_back({kSeries, run_series});
  experiments.kinds.push_back({kStudy, run_study});
}

}  // namespace kinex::reproduce
