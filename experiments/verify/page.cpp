// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "experiments/lab/html.h"
#include "experiments/lab/measures.h"
#include "experiments/verify/report_text.h"
#include "experiments/verify/tables.h"

namespace kinex::verify {

namespace {

std::string verdict_span(std::string_view verdict) {
  return fmt::format("<span class=\"v {0}\">{0}</span>", verdict);
}

std::string checks_table(const lab::CellResult& cell) {
  std::string text =
      "<table><tr><th>claim</th><th>quantity</th><th>expected</th><th>observed</th>"
      "<th>verdict</th><th>source</th></tr>";
  for (const lab::Check& check : cell.checks) {
    text += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        lab::escape(check.claim), lab::escape(check.quantity), lab::escape(check.expected), lab::escape(check.observed),
        verdict_span(lab::check_word(check.verdict)), lab::escape(check.source));
  }
  return text + "</table>";
}

std::string summary_part(const VerifyResult& result) {
  std::size_t counts[4] = {};
  for (const lab::CellResult& cell : result.cells) ++counts[static_cast<std::size_t>(cell.verdict())];
  for (const lab::GrowthResult& fit : result.growths) {
    ++counts[static_cast<std::size_t>(fit.check.verdict)];
  }
  for (const lab::StudyResult& study : result.studies) {
    ++counts[static_cast<std::size_t>(study.verdict())];
  }
  std::string text = "<div class=\"verdicts\">";
  for (const lab::Verdict verdict :
       {lab::Verdict::kConfirmed, lab::Verdict::kRefuted, lab::Verdict::kOpen, lab::Verdict::kGaveUp}) {
    text += fmt::format("<div><b>{}</b>{}</div>", counts[static_cast<std::size_t>(verdict)],
                        verdict_span(lab::check_word(verdict)));
  }
  // Its lines, a paragraph each.
  const std::string lines = lab::escape(closing_line(result));
  text += "</div>\n";
  for (std::size_t begin = 0, end; (end = lines.find('\n', begin)) != lines.npos; begin = end + 1) {
    text += "<p>" + lines.substr(begin, end - begin) + "</p>\n";
  }
  if (result.interrupted) {
    text += "<p><b>Interrupted:</b> only what was finished is here.</p>\n";
  }
  return text;
}

// The checks that did not pass, with reasons; empty if all passed.
std::string trouble_part(const VerifyResult& result) {
  std::string text;
  for (const lab::CellResult& cell : result.cells) {
    if (cell.verdict() == lab::Verdict::kConfirmed) continue;
    const CellRow row = cell_row(cell);
    text +=
        fmt::format("<h3>{} &middot; {} &middot; n = {} &middot; {}</h3>\n", lab::escape(row.structure),
                    lab::escape(row.workload), row.n, verdict_span(row.verdict));
    text += checks_table(cell);
    for (const std::string& file : cell.kept) {
      text += "<p>Scene kept: <code>" + lab::escape(file) + "</code></p>\n";
    }
  }
  return text.empty() ? text : "<h2>What did not pass</h2>\n" + text;
}

std::string fits_part(const VerifyResult& result) {
  if (result.growths.empty()) return "";
  std::string text =
      "<h2>Growth</h2>\n<table><tr><th>structure</th><th>family</th><th>expected</th><th>fitted</"
      "th>"
      "<th class=\"r\">sizes</th><th class=\"r\">chi&sup2; / degrees</th><th>verdict</th>"
      "<th>source</th></tr>\n";
  for (const lab::GrowthResult& growth : result.growths) {
    text += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"r\">{}</td>"
        "<td class=\"r\">{}</td><td>{}</td><td>{}</td></tr>\n",
        lab::escape(growth.claim.structure), lab::escape(growth.claim.family),
        lab::escape(growth.check.expected), lab::escape(growth.check.observed),
        growth.points.size(),
        growth.fit && growth.fit->weighted
            ? fmt::format("{:.2f} / {}", growth.fit->chi_square, growth.fit->degrees) +
                  (growth.corrected && growth.corrected->weighted
                       ? fmt::format("; {:.2f} / {}", growth.corrected->chi_square,
                                     growth.corrected->degrees)
                       : "")
            : "-",
        verdict_span(lab::check_word(growth.check.verdict)), lab::escape(growth.check.source));
  }
  return text +
         "</table>\n<p class=\"facts\">Intervals: 95 %, Student's t; widened where the points "
         "scatter more than their standard errors allow. No chi&sup2;: counts without errors; the "
         "interval is that of their scatter about the power. Where chance does not explain the "
         "chi&sup2; of a power, a term of lower order is fitted with it, which decides. A fit that "
         "passes is consistent with its law; other laws may be too: see its neighbours.</p>\n";
}

std::string tables_part(const std::vector<lab::Table>& tables) {
  std::string text;
  for (const lab::Table& table : tables) {
    text += "<h2>" + lab::escape(table.title) + "</h2>\n<p class=\"facts\">" + lab::escape(table.note) +
            "</p>\n<table><tr>";
    for (const std::string& cell : table.header) text += "<th>" + lab::escape(cell) + "</th>";
    text += "</tr>\n";
    std::string scenes;
    for (const auto& row : table.rows) {
      const bool first = row[0] + " " + row[1] != scenes;
      scenes = row[0] + " " + row[1];
      text += first ? "<tr class=\"first\">" : "<tr>";
      for (std::size_t i = 0; i < row.size(); ++i) {
        text += (i == 0 || i == 2 ? "<td>" : "<td class=\"r\">") + lab::escape(row[i]) + "</td>";
      }
      text += "</tr>\n";
    }
    text += "</table>\n";
  }
  return text;
}

std::string studies_part(const VerifyResult& result) {
  std::string text;
  for (const lab::StudyResult& study : result.studies) {
    text += "<h2>" + lab::escape(study.table.title) + " &middot; " +
            verdict_span(lab::check_word(study.verdict())) + "</h2>\n<table><tr>";
    for (const std::string& cell : study.table.header) text += "<th>" + lab::escape(cell) + "</th>";
    text += "</tr>\n";
    for (const auto& row : study.table.rows) {
      text += "<tr>";
      for (const std::string& cell : row) text += "<td>" + lab::escape(cell) + "</td>";
      text += "</tr>\n";
    }
    text += "</table>\n<p class=\"facts\">";
    for (const lab::Check& check : study.checks) {
      text += lab::escape(check.claim + ": expected " + check.expected + ", observed " + check.observed +
                     " (" + check.source + ")") +
              " " + verdict_span(lab::check_word(check.verdict)) + "<br>\n";
    }
    text += "</p>\n";
  }
  return text;
}

std::string cells_part(const VerifyResult& result) {
  const bool bounds =
      std::any_of(result.cells.begin(), result.cells.end(),
                  [](const lab::CellResult& cell) { return cell_row(cell).bound != "-"; });
  std::string text =
      "<h2>All cells</h2>\n<p class=\"facts\">Events are means over the runs where there are "
      "several. " +
      std::string(bounds ? "Bound: the hard bound on the events. " : "") +
      "exact/double: CPU time of the simulation on the first "
      "scene; &ldquo;differs&rdquo;: doubles handled other events, so times say nothing; "
      "&ldquo;-&rdquo;: too short to be measured.</p>\n"
      "<table><tr><th>structure</th><th>workload</th><th class=\"r\">n</th><th "
      "class=\"r\">runs</th>"
      "<th class=\"r\">external</th><th class=\"r\">internal</th>" +
      (bounds ? "<th class=\"r\">bound</th>" : "") +
      "<th>expected</th><th>observed</th><th>checks</th><th class=\"r\">exact/double</th>"
      "<th>verdict</th></tr>\n";
  std::string structure;
  for (const lab::CellResult& cell : result.cells) {
    const CellRow row = cell_row(cell);
    const bool first = row.structure != structure;
    structure = row.structure;
    text += fmt::format(
        "<tr{}><td>{}</td><td>{}</td><td class=\"r\">{}</td><td class=\"r\">{}</td>"
        "<td class=\"r\">{}</td><td class=\"r\">{}</td>{}<td>{}</td><td>{}</td>"
        "<td><details><summary>{}</summary><div>{}</div></details></td><td "
        "class=\"r\">{}</td><td>{}</td></tr>\n",
        first ? " class=\"first\"" : "", lab::escape(row.structure), lab::escape(row.workload), row.n,
        row.runs, row.external, row.internal,
        bounds ? "<td class=\"r\">" + row.bound + "</td>" : "", lab::escape(row.expected),
        lab::escape(row.observed), row.checks, checks_table(cell), row.ratio, verdict_span(row.verdict));
  }
  return text + "</table>\n";
}

}  // namespace

std::string verify_page(const VerifyResult& result, const std::vector<lab::Figure>& figures,
                        const lab::Drawings& drawings, const lab::PageFacts& facts) {
  std::string page = lab::html_head("kinex verify");
  page +=
      "<p class=\"facts\">Do kinetic data structures do what their theory "
      "says? Counted in exact arithmetic, with audits by independent code.</p>\n";
  page += summary_part(result);
  page += trouble_part(result);
  page += fits_part(result);
  page += tables_part(neighbours_tables(result.growths));
  page += tables_part(measures_tables(result.cells));
  page += studies_part(result);
  page += lab::plots_part(figures, drawings);
  page += cells_part(result);
  page += lab::facts_part(facts);
  return page + "</body></html>\n";
}

}  // namespace kinex::verify
