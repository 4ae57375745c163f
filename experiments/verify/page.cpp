// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "experiments/lab/html_page.h"
#include "experiments/lab/scene_command.h"
#include "experiments/verify/report_text.h"
#include "experiments/verify/tables.h"
#include "experiments/verify/verdict_lines.h"

namespace kinex::verify {

namespace {

using lab::escape;
using lab::HtmlColumn;
using lab::HtmlRow;

std::string verdict_span(std::string_view verdict) {
  return fmt::format("<span class=\"v {0}\">{0}</span>", verdict);
}

std::string checks_table(const lab::CellResult& cell) {
  std::string text =
      "<table><thead><tr><th>claim</th><th>quantity</th><th>expected</th><th>observed</th>"
      "<th>verdict</th><th>source</th></tr></thead><tbody>";
  for (const lab::Check& check : cell.checks) {
    text += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        escape(check.claim), escape(check.quantity), escape(check.expected), escape(check.observed),
        verdict_span(lab::check_word(check.verdict)), escape(check.source));
  }
  return text + "</tbody></table>";
}

// Anchor of a cell.
std::string id_of(const lab::CellResult& cell) {
  return lab::anchor_of(fmt::format("cell {} {} n {}", cell.cell.structure,
                                    cell.cell.workload_text(), cell.cell.parameters.n));
}

// How the cell's runs are made again: seeds, scene, commit, commands.
std::string origin_part(const lab::CellResult& cell, const lab::PageFacts& facts) {
  std::string text = "<p class=\"facts\">";
  if (!cell.trials.empty()) {
    const lab::Measurement& first = cell.trials.front().measurement;
    if (cell.cell.random) {
      text += cell.trials.size() == 1 ? fmt::format("seed {}; ", first.seed)
                                      : fmt::format("seeds {} to {}; ", first.seed,
                                                    cell.trials.back().measurement.seed);
    }
    text += fmt::format("{}scene {} (SHA-256 {}); ", cell.trials.size() == 1 ? "" : "first ",
                        escape(first.scene_name), first.scene_hash);
  }
  text += fmt::format("commit {}{}</p>\n", escape(facts.build.commit),
                      facts.build.dirty ? " with changes" : "");
  if (cell.cell.mirrored || cell.cell.turned) {
    return text + fmt::format(
                      "<p>The scene is {}, which <code>kinex gen</code> does not do. The cell is "
                      "part of</p>\n<pre>{}</pre>\n",
                      cell.cell.mirrored ? "mirrored" : "turned", escape(facts.command));
  }
  return text + "<p>The same scene, its run, and a page that plays it:</p>\n<pre>" +
         escape(
             lab::scene_commands(cell.cell.workload, cell.cell.parameters, cell.cell.structure)) +
         "</pre>\n";
}

// The checks that did not pass, with reasons; empty if all passed.
std::string trouble_part(const VerifyResult& result, const lab::PageFacts& facts) {
  std::string text;
  for (const lab::CellResult& cell : result.cells) {
    if (cell.verdict() == lab::Verdict::kConfirmed) continue;
    const CellRow row = cell_row(cell);
    text += fmt::format("<h3><a href=\"#{}\">{} &middot; {} &middot; n = {}</a> &middot; {}</h3>\n",
                        id_of(cell), escape(row.structure), escape(row.workload), row.n,
                        verdict_span(row.verdict));
    text += "<div class=\"wide\">" + checks_table(cell) + "</div>" + origin_part(cell, facts);
    for (const std::string& file : cell.kept) {
      text += "<p>Scene kept: <code>" + escape(file) + "</code></p>\n";
    }
  }
  for (const lab::GrowthResult& growth : result.growths) {
    if (growth.check.verdict == lab::Verdict::kConfirmed) continue;
    text +=
        fmt::format("<h3>{} &middot; growth, {} &middot; {}</h3>\n<p>Expected {}, fitted {}.</p>\n",
                    escape(growth.claim.structure), escape(growth.claim.family),
                    verdict_span(lab::check_word(growth.check.verdict)),
                    escape(growth.check.expected), escape(growth.check.observed));
  }
  for (const lab::StudyResult& study : result.studies) {
    for (const lab::Check& check : study.checks) {
      if (check.verdict == lab::Verdict::kConfirmed) continue;
      text += fmt::format("<h3>{} &middot; {} &middot; {}</h3>\n<p>Expected {}, observed {}.</p>\n",
                          escape(study.name), escape(check.claim),
                          verdict_span(lab::check_word(check.verdict)), escape(check.expected),
                          escape(check.observed));
    }
  }
  return text;
}

std::string chi_square_text(const lab::GrowthResult& growth) {
  if (!growth.fit || !growth.fit->weighted) return "-";
  std::string text = fmt::format("{:.2f} / {}", growth.fit->chi_square, growth.fit->degrees);
  if (growth.corrected && growth.corrected->weighted) {
    text += fmt::format("; {:.2f} / {}", growth.corrected->chi_square, growth.corrected->degrees);
  }
  return text;
}

std::string fits_part(const VerifyResult& result) {
  if (result.growths.empty()) return "";
  std::vector<HtmlRow> rows;
  for (const lab::GrowthResult& growth : result.growths) {
    rows.push_back(
        {{escape(growth.claim.structure), escape(growth.claim.family),
          escape(growth.check.expected), escape(growth.check.observed),
          std::to_string(growth.points.size()), chi_square_text(growth),
          verdict_span(lab::check_word(growth.check.verdict)), escape(growth.check.source)}});
  }
  return lab::html_table({{"structure"},
                          {"family"},
                          {"expected"},
                          {"fitted"},
                          {"sizes", true},
                          {"chi&sup2; / degrees", true},
                          {"verdict"},
                          {"source"}},
                         rows) +
         "<p class=\"facts\">Intervals: 95 %, Student's t; widened where the points "
         "scatter more than their standard errors allow. No chi&sup2;: counts without errors; the "
         "interval is that of their scatter about the power. Where chance does not explain the "
         "chi&sup2; of a power, a term of lower order is fitted with it, which decides. A fit that "
         "passes is consistent with its law; other laws may be too: see its neighbours.</p>\n";
}

bool is_number(const std::string& text) {
  return !text.empty() &&
         (std::isdigit(static_cast<unsigned char>(text[0])) != 0 || text == "-" || text[0] == '<');
}

// A column is one of numbers if all of its cells are.
std::string table_html(const lab::Table& table) {
  std::vector<HtmlColumn> columns;
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    const bool numbers =
        i > 0 && std::all_of(table.rows.begin(), table.rows.end(),
                             [&](const auto& row) { return i >= row.size() || is_number(row[i]); });
    columns.push_back({escape(table.header[i]), numbers});
  }
  std::vector<HtmlRow> rows;
  std::string scenes;
  for (const auto& cells : table.rows) {
    HtmlRow row;
    for (const std::string& cell : cells) row.cells.push_back(escape(cell));
    const std::string group = cells.size() < 2 ? "" : cells[0] + " " + cells[1];
    row.first = group != scenes;
    scenes = group;
    rows.push_back(std::move(row));
  }
  const std::string note =
      table.note.empty() ? "" : "<p class=\"facts\">" + escape(table.note) + "</p>\n";
  return note + lab::html_table(columns, rows);
}

std::string study_html(const lab::StudyResult& study) {
  std::string text = "<p class=\"facts\">";
  for (const lab::Check& check : study.checks) {
    text += escape(check.claim + ": expected " + check.expected + ", observed " + check.observed +
                   " (" + check.source + ")") +
            " " + verdict_span(lab::check_word(check.verdict)) + "<br>\n";
  }
  return text + "</p>\n" + table_html(study.table);
}

std::string cells_part(const VerifyResult& result, const lab::PageFacts& facts) {
  if (result.cells.empty()) return "";
  const bool bounds =
      std::any_of(result.cells.begin(), result.cells.end(),
                  [](const lab::CellResult& cell) { return cell_row(cell).bound != "-"; });
  std::vector<HtmlColumn> columns{{"structure"},  {"workload"},       {"n", true},
                                  {"runs", true}, {"external", true}, {"internal", true}};
  if (bounds) columns.push_back({"bound", true});
  for (const char* name : {"expected", "observed", "checks"}) columns.push_back({name});
  columns.push_back({"exact/double", true});
  columns.push_back({"verdict"});
  std::vector<HtmlRow> rows;
  std::string structure;
  for (const lab::CellResult& cell : result.cells) {
    const CellRow row = cell_row(cell);
    HtmlRow html;
    html.cells = {escape(row.structure), escape(row.workload), row.n, row.runs,
                  row.external,          row.internal};
    if (bounds) html.cells.push_back(row.bound);
    html.cells.push_back(escape(row.expected));
    html.cells.push_back(escape(row.observed));
    html.cells.push_back("<button class=\"open\" title=\"Checks, seeds, scene, commands\">" +
                         row.checks + "</button>");
    html.cells.push_back(row.ratio);
    html.cells.push_back(verdict_span(row.verdict));
    html.id = id_of(cell);
    html.more = checks_table(cell) + origin_part(cell, facts) +
                fmt::format("<p><a href=\"#{}\">link to this cell</a></p>\n", html.id);
    html.first = row.structure != structure;
    structure = row.structure;
    rows.push_back(std::move(html));
  }
  return "<p class=\"facts\">Events are means over the runs where there are several. " +
         std::string(bounds ? "Bound: the hard bound on the events. " : "") +
         "exact/double: CPU time of the simulation on the first scene; &ldquo;differs&rdquo;: "
         "doubles handled "
         "other events, so times say nothing; &ldquo;-&rdquo;: too short to be measured. A click "
         "on a cell's "
         "checks shows them with its seeds, scene and commands.</p>\n" +
         lab::html_table(columns, rows);
}

}  // namespace

std::string verify_page(const VerifyResult& result, const std::vector<lab::Figure>& figures,
                        const lab::Drawings& drawings, const lab::PageFacts& facts) {
  std::string lead = "<p>" + escape(work_line(result)) + ".</p>\n";
  if (const std::string seeds = seeds_line(result); !seeds.empty())
    lead += "<p>" + escape(seeds) + "</p>\n";
  if (result.interrupted) lead += "<p><b>Interrupted:</b> only what was finished is here.</p>\n";
  lead +=
      "<p class=\"facts\">Do kinetic data structures do what their theory says? Counted in exact "
      "arithmetic, "
      "with audits by independent code.</p>\n";
  lab::HtmlPage page("kinex verify", verdict_line(result, facts.seconds),
                     result.verdict() == lab::Verdict::kConfirmed && !result.interrupted, lead);
  page.section("trouble", "What did not pass", trouble_part(result, facts));
  page.section("plots", "Plots", lab::plots_part(figures, drawings));
  page.section("growth", "Growth", fits_part(result));
  for (const lab::Table& table : neighbours_tables(result.growths)) {
    page.section(lab::anchor_of(table.title), table.title, table_html(table));
  }
  for (const lab::Table& table : measures_tables(result.cells)) {
    page.section(lab::anchor_of(table.title), table.title, table_html(table));
  }
  for (const lab::StudyResult& study : result.studies) {
    page.section(lab::anchor_of(study.table.title), study.table.title, study_html(study));
  }
  page.section("cells", "All cells", cells_part(result, facts));
  page.section("origin", "How this was made", lab::facts_part(facts));
  return page.text();
}

}  // namespace kinex::verify
