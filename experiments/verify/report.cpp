// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "experiments/lab/scene_command.h"
#include "experiments/verify/plots.h"
#include "experiments/verify/report_text.h"

namespace kinex::verify {

namespace {

using lab::html;
using lab::Html;
using lab::HtmlRow;

Html checks_table(const lab::CellResult& cell) {
  Html rows;
  for (const lab::Check& check : cell.checks) {
    rows += html("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                 lab::verdict_mark(check.verdict), check.claim, check.quantity, check.expected,
                 check.observed, check.source);
  }
  return html(
      "<table><thead><tr><th>verdict</th><th>claim</th><th>quantity</th><th>expected</th>"
      "<th>observed</th><th>source</th></tr></thead><tbody>{}</tbody></table>",
      rows);
}

// Anchor of a cell.
std::string id_of(const lab::CellResult& cell) {
  return lab::anchor_of(fmt::format("cell {} {} n {}", cell.cell.structure,
                                    cell.cell.workload_text(), cell.cell.parameters.n));
}

// How the cell's runs are made again: seeds, scene, commit, commands.
Html origin_of(const lab::CellResult& cell, const lab::PageFacts& facts) {
  std::string scene;
  if (!cell.trials.empty()) {
    const lab::Measurement& first = cell.trials.front().measurement;
    const bool one = cell.trials.size() == 1;
    if (cell.cell.random) {
      const std::uint64_t last = cell.trials.back().measurement.seed;
      scene = one ? fmt::format("seed {}; ", first.seed)
                  : fmt::format("seeds {} to {}; ", first.seed, last);
    }
    scene += fmt::format("{}scene {} (SHA-256 {}); ", one ? "" : "first ", first.scene_name,
                         first.scene_hash);
  }
  const Html origin = lab::origin_part(scene, facts);
  if (const std::string changes = cell.cell.changes_text(); !changes.empty()) {
    return origin + html("<p>The scene is {}, which <code>kinex gen</code> does not do. The cell is "
                         "part of</p>\n{}",
                         changes, lab::commands_part(facts.command));
  }
  return origin + html("<p>The same scene, its run, and a page that plays it:</p>\n{}",
                       lab::commands_part(lab::scene_commands(
                           cell.cell.workload, cell.cell.parameters, cell.cell.structure)));
}

// The checks that did not pass, with reasons; empty if all passed.
Html trouble_part(const VerifyResult& result, const lab::PageFacts& facts) {
  Html text;
  const auto add = [&](const std::string& structure, const std::string& what,
                       const lab::Check& check, const char* found) {
    if (check.verdict <= lab::Verdict::kAgrees) return;
    text += html("<h3>{} &middot; {} &middot; {}</h3>\n<p>Expected {}, {} {}.</p>\n", structure, what,
                 lab::verdict_mark(check.verdict), check.expected, found, check.observed);
  };
  for (const lab::CellResult& cell : result.cells) {
    if (cell.verdict() == lab::Verdict::kConfirmed) continue;
    const CellRow row = cell_row(cell);
    text += html("<h3><a href=\"#{}\">{} &middot; {} &middot; n = {}</a> &middot; {}</h3>\n",
                 id_of(cell), row.structure, row.workload, row.n, lab::verdict_mark(cell.verdict()));
    text += html("<div class=\"wide\">{}</div>{}", checks_table(cell), origin_of(cell, facts));
    for (const std::string& file : cell.kept) {
      text += html("<p>Scene kept: <code>{}</code></p>\n", file);
    }
  }
  for (const lab::GrowthResult& growth : result.growths) {
    add(growth.claim.structure, "growth, " + growth.claim.family, growth.check, "fitted");
  }
  for (const lab::StudyResult& study : result.studies) {
    for (const lab::Check& check : study.checks) add(study.name, check.claim, check, "observed");
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

Html fits_part(const VerifyResult& result) {
  std::vector<HtmlRow> rows;
  for (const lab::GrowthResult& growth : result.growths) {
    const lab::Check& check = growth.check;
    rows.push_back({{growth.claim.structure, growth.claim.family, check.expected, check.observed,
                     std::to_string(growth.points.size()), chi_square_text(growth),
                     lab::verdict_mark(check.verdict), check.source}});
  }
  if (rows.empty()) return {};
  return lab::html_table({{"structure"},
                          {"family"},
                          {"expected"},
                          {"fitted"},
                          {"sizes", true},
                          {"chi^2 / degrees", true},
                          {"verdict", false, true},
                          {"source"}},
                         rows) +
         lab::note_part(
             "Intervals: 95 %, Student's t; widened where the points scatter more than their standard "
             "errors allow. No chi^2: counts without errors; the interval is that of their scatter "
             "about the power. Where chance does not explain the chi^2 of a power, a term of lower "
             "order is fitted with it, which decides. A power is refuted only if it does not fit with "
             "that term either. A fit that passes is consistent with its law; other laws may be too: "
             "see its neighbours.");
}

Html study_part(const lab::StudyResult& study) {
  Html text;
  for (const lab::Check& check : study.checks) {
    text += html("{} {}: expected {}, observed {} ({})<br>\n", lab::verdict_mark(check.verdict),
                 check.claim, check.expected, check.observed, check.source);
  }
  return html("<p class=\"facts\">{}</p>\n{}", text, lab::html_table(study.table));
}

Html cells_part(const VerifyResult& result, const lab::PageFacts& facts) {
  if (result.cells.empty()) return {};
  const bool bounds =
      std::any_of(result.cells.begin(), result.cells.end(),
                  [](const lab::CellResult& cell) { return cell_row(cell).bound != "-"; });
  std::vector<HtmlRow> rows;
  std::string structure;
  for (const lab::CellResult& cell : result.cells) {
    const CellRow row = cell_row(cell);
    const std::vector<std::string> texts = row.texts(bounds);
    HtmlRow one;
    one.cells.assign(texts.begin(), texts.end());
    one.cells.end()[-3] = lab::unfolding_button(row.checks, "Checks, seeds, scene, commands");
    one.cells.back() = lab::verdict_mark(cell.verdict());
    one.id = id_of(cell);
    one.more = checks_table(cell) + origin_of(cell, facts) +
               html("<p><a href=\"#{}\">link to this cell</a></p>\n", one.id);
    one.first = row.structure != structure;
    structure = row.structure;
    rows.push_back(std::move(one));
  }
  return lab::note_part(
             "Events are means over the runs where there are several. " +
             std::string(bounds ? "Bound: the hard bound on the events (where there is none on all of them, "
                                  "on those of one structure). "
                                : "") +
             "exact/double: CPU time of the simulation on the first scene; \"differs\": doubles "
             "handled other events, so times say nothing; \"-\": too short to be measured. A click on "
             "a cell's checks shows them with its seeds, scene and commands.") +
         lab::html_table(lab::html_columns(cell_columns(bounds)), rows);
}

}  // namespace

lab::Report verify_report(const VerifyResult& result, const lab::PageFacts& facts) {
  lab::Report report;
  report.title = "kinex verify";
  report.verdict = verdict_line(result, facts.taken);
  report.good = result.verdict() <= lab::Verdict::kAgrees;
  report.interrupted = result.interrupted;
  report.lead = html("<p>{}.</p>\n", work_line(result));
  if (const std::string seeds = seeds_line(result); !seeds.empty()) {
    report.lead += html("<p>{}</p>\n", seeds);
  }
  report.question =
      "Do kinetic data structures do what their theory says? Counted in exact arithmetic, with audits "
      "by independent code.";
  report.figures = verify_figures(result);
  report.before = {{"trouble", "What did not pass", trouble_part(result, facts)}};
  report.after = {{"growth", "Growth", fits_part(result)}};
  for (const lab::Table& table : more_tables(result)) {
    report.after.push_back({lab::anchor_of(table.title), table.title, lab::html_table(table)});
  }
  for (const lab::StudyResult& study : result.studies) {
    report.after.push_back(
        {lab::anchor_of(study.table.title), study.table.title, study_part(study)});
  }
  report.after.push_back({"cells", "All cells", cells_part(result, facts)});
  return report;
}

}  // namespace kinex::verify
