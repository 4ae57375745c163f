// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/report.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "experiments/lab/scene_command.h"
#include "experiments/trade/plots.h"
#include "experiments/trade/report_text.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

using lab::html;
using lab::Html;
using lab::HtmlRow;

// By standing.
constexpr lab::Verdict kColours[] = {lab::Verdict::kConfirmed, lab::Verdict::kOpen,
                                     lab::Verdict::kRefuted};

lab::Verdict colour_of(Standing standing) { return kColours[static_cast<std::size_t>(standing)]; }

std::string id_of(const CaseResult& one) {
  return lab::anchor_of("case " + one.which.structure + " " + one.which.name);
}

HtmlRow row_of(const CaseResult& one, const TradeRun& run) {
  const std::vector<std::string> texts = run_texts(one, run);
  HtmlRow row;
  row.cells.assign(texts.begin(), texts.end());
  row.cells.back() = lab::verdict_mark(colour_of(run.standing()), texts.back(), run.violation);
  return row;
}

Html standings_part(const TradeResult& result) {
  std::vector<HtmlRow> rows;
  for (const ArithmeticStandings& one : standings_of(result)) {
    HtmlRow row{{one.arithmetic}};
    for (std::size_t i = 0; i < one.cases.size(); ++i) {
      row.cells.push_back(one.cases[i] == 0
                              ? Html("-")
                              : lab::verdict_mark(kColours[i], std::to_string(one.cases[i])));
    }
    rows.push_back(std::move(row));
  }
  return lab::html_table({{"arithmetic"},
                          {"same events", true},
                          {"other events, valid", true},
                          {"wrong", true}},
                         rows) +
         lab::note_part(
             "Same events: all events of the exact run, none other, and in an order that agrees with "
             "the exact instants. Valid: other events, or events in another order, but every audited "
             "state agrees with an independent exact computation (events at one instant can be "
             "handled in many ways). Wrong: some state does not, or the run was corrupt or endless.");
}

Html bits_part(const TradeResult& result) {
  if (result.bits.empty()) return {};
  std::vector<HtmlRow> rows;
  for (const BitsGrowth& growth : result.growths) {
    rows.push_back({{growth.structure, growth.family, growth_text(*growth.most),
                     growth.percentile_99 ? growth_text(*growth.percentile_99) : "-"}});
  }
  return lab::note_part(
             "To tell two instants a < b apart a number needs ceil(log2(max(|a|, |b|) / (b - a))) + 1 "
             "significant bits. With fewer the run cannot know which event comes first.") +
         lab::html_table(
             {{"structure"}, {"family"}, {"most bits of a scene"}, {"of 99 % of the pairs"}}, rows);
}

// Every run of every scene in one table, to be filtered and sorted.
Html all_runs_part(const TradeResult& result) {
  std::vector<HtmlRow> rows;
  for (const CaseResult& one : result.cases) {
    for (const TradeRun& run : one.runs) {
      HtmlRow row = row_of(one, run);
      row.cells.insert(row.cells.begin(),
                       {one.which.structure, html("<a href=\"#{}\">{}</a>", id_of(one), one.which.name),
                        std::to_string(one.objects)});
      row.first = &run == &one.runs.front();
      rows.push_back(std::move(row));
    }
  }
  if (rows.empty()) return {};
  std::vector<lab::HtmlColumn> columns = lab::html_columns(run_columns());
  columns.insert(columns.begin(), {{"structure"}, {"scene"}, {"n", true}});
  return lab::html_table(columns, rows);
}

// Its runs; scene, commit and commands; folded.
Html case_part(const CaseResult& one, const lab::PageFacts& facts) {
  const TradeCase& which = one.which;
  if (one.runs.empty()) return html("<p id=\"{}\">{}</p>\n", id_of(one), case_heading(one));
  std::vector<HtmlRow> rows;
  for (const TradeRun& run : one.runs) rows.push_back(row_of(one, run));
  Html origin = lab::origin_part(
      fmt::format("scene {} (SHA-256 {}); ", one.scene_name, one.scene_hash), facts);
  if (!which.workload.empty()) {
    origin += lab::commands_part(
        lab::scene_commands(which.workload, which.parameters, which.structure) +
        "kinex trade scene.json -o trade");
  }
  return html("<details id=\"{}\"><summary>{}</summary>{}{}</details>\n", id_of(one), case_heading(one),
              lab::html_table(lab::html_columns(run_columns()), rows), origin);
}

Html cases_part(const TradeResult& result, const lab::PageFacts& facts) {
  if (result.cases.empty()) return {};
  Html text = lab::note_part(
      "Time: CPU time of the whole run, set-up included, best of several rounds in turn; memory: the "
      "largest number of bytes in motions, certificates, queue and structure. \"-\": the run did not "
      "reach its end, or is too short to be timed. An event is missed or invented if the two runs have "
      "it in different numbers; inversions are pairs of events in the wrong order. Errors are those of "
      "the events that both have.");
  for (const CaseResult& one : result.cases) text += case_part(one, facts);
  return text;
}

}  // namespace

lab::Report trade_report(const TradeResult& result, const lab::PageFacts& facts) {
  lab::Report report;
  report.title = "kinex trade";
  report.verdict = verdict_line(result, facts.taken);
  report.good = result.faults().empty();
  report.interrupted = result.interrupted;
  for (const std::string& fault : result.faults()) {
    report.lead += html("<p class=\"v text FAIL\">{}</p>\n", fault);
  }
  report.question =
      "What is gained and what is lost when a run is not exact? Every run is compared with the exact "
      "one, event by event, and its states are audited exactly.";
  report.figures = trade_figures(result);
  report.before = {{"standings",
                    result.cases.size() == 1
                         ? std::string("Was each right on the scene?")
                         : fmt::format("In how many of the {} scenes was each right?", result.cases.size()),
                    standings_part(result)}};
  report.after = {{"bits", "Bits needed", bits_part(result)},
                  {"runs", "All runs", all_runs_part(result)},
                  {"scenes", "All scenes", cases_part(result, facts)}};
  return report;
}

}  // namespace kinex::trade
