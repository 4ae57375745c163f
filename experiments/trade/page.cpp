// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/page.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "experiments/lab/html_page.h"
#include "experiments/lab/scene_command.h"
#include "experiments/trade/report.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

using lab::HtmlRow;

// The colours of the verdicts of html.h, by standing.
constexpr const char* kClasses[] = {"PASS", "INCONCLUSIVE", "FAIL"};

std::string standing_span(Standing standing, const std::string& text) {
  return fmt::format("<span class=\"v text {}\">{}</span>",
                     kClasses[static_cast<std::size_t>(standing)], lab::escape(text));
}

std::string faults_part(const TradeResult& result) {
  std::string text;
  if (result.interrupted) {
    text += "<p><b>Interrupted:</b> only what was finished is here.</p>\n";
  }
  for (const std::string& fault : result.faults()) {
    text += "<p class=\"v text FAIL\">" + lab::escape(fault) + "</p>\n";
  }
  return text;
}

std::string standings_part(const TradeResult& result) {
  std::vector<HtmlRow> rows;
  for (const ArithmeticStandings& one : standings_of(result)) {
    HtmlRow row{{lab::escape(one.arithmetic)}};
    for (std::size_t i = 0; i < one.cases.size(); ++i) {
      row.cells.push_back(one.cases[i] == 0 ? std::string("-")
                                            : standing_span(static_cast<Standing>(i),
                                                            std::to_string(one.cases[i])));
    }
    rows.push_back(std::move(row));
  }
  return lab::html_table({{"arithmetic"},
                          {"same events", true},
                          {"other events, valid", true},
                          {"wrong", true}},
                         rows) +
         "<p class=\"facts\">Same events: all events of the exact run, none other, and "
         "in an order that agrees with the exact instants. Valid: other events, or events in "
         "another order, but every audited state agrees with an independent exact computation "
         "(events at one instant can be handled in many ways). Wrong: some state does not, or the "
         "run was corrupt or endless.</p>\n";
}

// Scene, seed, commit and commands of a case.
std::string origin_part(const CaseResult& one, const lab::PageFacts& facts) {
  const TradeCase& which = one.which;
  std::string text = fmt::format(
      "<p class=\"facts\">scene {} (SHA-256 {}); commit {}{}</p>\n", lab::escape(one.scene_name),
      one.scene_hash, lab::escape(facts.build.commit), facts.build.dirty ? " with changes" : "");
  if (which.workload.empty()) return text;
  return text + "<pre>" +
         lab::escape(lab::scene_commands(which.workload, which.parameters, which.structure)) +
         "kinex trade scene.json -o trade</pre>\n";
}

std::string case_part(const CaseResult& one, const lab::PageFacts& facts) {
  const std::string id = lab::anchor_of("case " + one.which.structure + " " + one.which.name);
  std::string text = fmt::format("<h3 id=\"{0}\"><a href=\"#{0}\">{1}</a></h3>\n", id,
                                 lab::escape(case_heading(one)));
  if (one.runs.empty()) return text;
  std::vector<HtmlRow> rows;
  for (const TradeRun& run : one.runs) {
    const TradeRow row = trade_row(one, run);
    rows.push_back({{lab::escape(row.arithmetic), row.time, row.memory, row.missed, row.invented,
                     row.inversions, lab::escape(row.first), row.error, row.ulps, row.state,
                     fmt::format("<span title=\"{}\">{}</span>", lab::escape(run.violation),
                                 standing_span(run.standing(), row.standing))}});
  }
  return text +
         lab::html_table({{"arithmetic"},
                          {"time / double", true},
                          {"memory / double", true},
                          {"missed", true},
                          {"invented", true},
                          {"inversions", true},
                          {"first difference: event, time"},
                          {"error, s", true},
                          {"error, ulps", true},
                          {"valid states", true},
                          {"outcome"}},
                         rows) +
         "<details><summary>scene and commands</summary>" + origin_part(one, facts) +
         "</details>\n";
}

// Every run of every scene in one table, to be filtered and sorted.
std::string all_runs_part(const TradeResult& result) {
  std::vector<HtmlRow> rows;
  for (const CaseResult& one : result.cases) {
    const std::string id = lab::anchor_of("case " + one.which.structure + " " + one.which.name);
    for (const TradeRun& run : one.runs) {
      const TradeRow row = trade_row(one, run);
      rows.push_back({{lab::escape(one.which.structure),
                       fmt::format("<a href=\"#{}\">{}</a>", id, lab::escape(one.which.name)),
                       std::to_string(one.objects), lab::escape(row.arithmetic), row.time,
                       row.memory, row.missed, row.invented, row.inversions, row.ulps, row.state,
                       standing_span(run.standing(), row.standing)},
                      "",
                      "",
                      &run == &one.runs.front()});
    }
  }
  if (rows.empty()) return "";
  return lab::html_table({{"structure"},
                          {"scene"},
                          {"n", true},
                          {"arithmetic"},
                          {"time / double", true},
                          {"memory / double", true},
                          {"missed", true},
                          {"invented", true},
                          {"inversions", true},
                          {"error, ulps", true},
                          {"valid states", true},
                          {"outcome"}},
                         rows);
}

std::string cases_part(const TradeResult& result, const lab::PageFacts& facts) {
  if (result.cases.empty()) return "";
  std::string text =
      "<p class=\"facts\">Time: CPU time of the whole run, set-up included, "
      "best of several rounds in turn; memory: the largest number of bytes in motions, "
      "certificates, queue and structure. &ldquo;-&rdquo;: the run did not reach its end, or is "
      "too short to be timed. An event is missed or invented if the two runs have it in different "
      "numbers; inversions are pairs of events in the wrong order. Errors are those of the events "
      "that both have.</p>\n";
  for (const CaseResult& one : result.cases) text += case_part(one, facts);
  return text;
}

std::string bits_part(const TradeResult& result) {
  if (result.bits.empty()) return "";
  std::vector<HtmlRow> rows;
  for (const BitsGrowth& growth : result.growths) {
    rows.push_back(
        {{lab::escape(growth.structure), lab::escape(growth.family),
          lab::escape(growth_text(*growth.most)),
          growth.percentile_99 ? lab::escape(growth_text(*growth.percentile_99)) : "-"}});
  }
  return "<p class=\"facts\">To tell two instants a &lt; b apart a number needs "
         "ceil(log2(max(|a|, |b|) / (b - a))) + 1 significant bits. With fewer the run cannot know "
         "which event comes first.</p>\n" +
         lab::html_table(
             {{"structure"}, {"family"}, {"most bits of a scene"}, {"of 99 % of the pairs"}}, rows);
}

}  // namespace

std::string trade_page(const TradeResult& result, const std::vector<lab::Figure>& figures,
                       const lab::Drawings& drawings, const lab::PageFacts& facts) {
  lab::HtmlPage page(
      "kinex trade", verdict_line(result, facts.seconds),
      result.faults().empty() && !result.interrupted,
      faults_part(result) +
          "<p class=\"facts\">What is gained and what is lost when a run is not exact? Every run "
          "is "
          "compared with the exact one, event by event, and its states are audited exactly.</p>\n");
  page.section("standings",
               fmt::format("In how many of the {} scenes was each right?", result.cases.size()),
               standings_part(result));
  page.section("plots", "Plots", lab::plots_part(figures, drawings));
  page.section("bits", "Bits needed", bits_part(result));
  page.section("runs", "All runs", all_runs_part(result));
  page.section("scenes", "All scenes", cases_part(result, facts));
  page.section("origin", "How this was made", lab::facts_part(facts));
  return page.text();
}

}  // namespace kinex::trade
