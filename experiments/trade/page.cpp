// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/page.h"

#include <fmt/format.h>

#include "experiments/trade/report.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

// The colours of the verdicts of html.h, by standing.
constexpr const char* kClasses[] = {"PASS", "INCONCLUSIVE", "FAIL"};

std::string standing_span(Standing standing, const std::string& text) {
  return fmt::format("<span class=\"v {}\" style=\"white-space: normal\">{}</span>",
                     kClasses[static_cast<std::size_t>(standing)], lab::escape(text));
}

std::string faults_part(const TradeResult& result) {
  std::string text;
  if (result.interrupted) {
    text += "<p><b>Interrupted:</b> only what was finished is here.</p>\n";
  }
  for (const std::string& fault : result.faults()) {
    text += "<p class=\"v FAIL\">" + lab::escape(fault) + "</p>\n";
  }
  return text;
}

std::string standings_part(const TradeResult& result) {
  std::string text = fmt::format(
      "<h2>In how many of the {} scenes was each right?</h2>\n<table style=\"width: auto\"><tr>"
      "<th>arithmetic</th><th class=\"r\">same events</th><th class=\"r\">other events, valid</th>"
      "<th class=\"r\">wrong</th></tr>\n",
      result.cases.size());
  for (const ArithmeticStandings& one : standings_of(result)) {
    text += "<tr><td>" + lab::escape(one.arithmetic) + "</td>";
    for (std::size_t i = 0; i < one.cases.size(); ++i) {
      text += fmt::format("<td class=\"r\">{}</td>",
                          one.cases[i] == 0 ? std::string("-")
                                            : standing_span(static_cast<Standing>(i),
                                                            std::to_string(one.cases[i])));
    }
    text += "</tr>\n";
  }
  return text +
         "</table>\n<p class=\"facts\">Same events: all events of the exact run, none other, and "
         "in an order that agrees with the exact instants. Valid: other events, or events in "
         "another order, but every audited state agrees with an independent exact computation "
         "(events at one instant can be handled in many ways). Wrong: some state does not, or the "
         "run was corrupt or endless.</p>\n";
}

std::string case_part(const CaseResult& one) {
  std::string text = "<h3>" + lab::escape(case_heading(one)) + "</h3>\n";
  if (one.runs.empty()) return text;
  text +=
      "<table><tr><th>arithmetic</th><th class=\"r\">time / double</th><th class=\"r\">memory / "
      "double</th><th class=\"r\">missed</th><th class=\"r\">invented</th><th "
      "class=\"r\">inversions</th><th>first difference: event, time</th><th class=\"r\">error, "
      "s</th><th class=\"r\">error, ulps</th><th class=\"r\">valid states</th><th>outcome</th></tr>"
      "\n";
  for (const TradeRun& run : one.runs) {
    const TradeRow row = trade_row(one, run);
    text += fmt::format(
        "<tr><td>{}</td><td class=\"r\">{}</td><td class=\"r\">{}</td><td class=\"r\">{}</td><td "
        "class=\"r\">{}</td><td class=\"r\">{}</td><td>{}</td><td class=\"r\">{}</td><td "
        "class=\"r\">{}</td><td class=\"r\">{}</td><td title=\"{}\">{}</td></tr>\n",
        lab::escape(row.arithmetic), row.time, row.memory, row.missed, row.invented, row.inversions,
        lab::escape(row.first), row.error, row.ulps, row.state, lab::escape(run.violation),
        standing_span(run.standing(), row.standing));
  }
  return text + "</table>\n";
}

std::string cases_part(const TradeResult& result) {
  std::string text =
      "<h2>All scenes</h2>\n<p class=\"facts\">Time: CPU time of the whole run, set-up included, "
      "best of several rounds in turn; memory: the largest number of bytes in motions, "
      "certificates, queue and structure. &ldquo;-&rdquo;: the run did not reach its end, or is "
      "too short to be timed. An event is missed or invented if the two runs have it in different "
      "numbers; inversions are pairs of events in the wrong order. Errors are those of the events "
      "that both have.</p>\n";
  for (const CaseResult& one : result.cases) text += case_part(one);
  return text;
}

std::string bits_part(const TradeResult& result) {
  if (result.bits.empty()) return "";
  std::string text =
      "<h2>Bits needed</h2>\n<p class=\"facts\">To tell two instants a &lt; b apart a number needs "
      "ceil(log2(max(|a|, |b|) / (b - a))) + 1 significant bits. With fewer the run cannot know "
      "which event comes first.</p>\n<table><tr><th>structure</th><th>family</th><th>most bits "
      "of a scene</th><th>of 99 % of the pairs</th></tr>\n";
  for (const BitsGrowth& growth : result.growths) {
    text += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        lab::escape(growth.structure), lab::escape(growth.family),
                        lab::escape(growth_text(*growth.most)),
                        growth.percentile_99 ? lab::escape(growth_text(*growth.percentile_99)) : "-");
  }
  return text + "</table>\n";
}

}  // namespace

std::string trade_page(const TradeResult& result, const std::vector<lab::Figure>& figures,
                       const lab::Drawings& drawings, const lab::PageFacts& facts) {
  std::string page = lab::html_head("kinex trade");
  page +=
      "<p class=\"facts\">What is gained and what is lost when a run is not exact? Every run is "
      "compared with the exact one, event by event, and its states are audited exactly.</p>\n";
  page += faults_part(result);
  page += standings_part(result);
  page += lab::plots_part(figures, drawings);
  page += bits_part(result);
  page += cases_part(result);
  page += lab::facts_part(facts);
  return page + "</body></html>\n";
}

}  // namespace kinex::trade
