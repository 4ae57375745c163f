// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/page.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <vector>

#include "experiments/verify/report_text.h"

namespace kinex {

namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>kinex verify</title>
<style>
:root { color-scheme: light; }
body { font: 15px/1.45 system-ui, "Helvetica Neue", Arial, sans-serif; color: #1a1a1a;
  background: #fff; margin: 2rem auto; padding: 0 1.5rem; max-width: 1360px;
  position: relative; }
h1 { font-size: 1.6rem; margin-bottom: .2rem; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
p.facts { color: #555; margin: .2rem 0; }
.verdicts { display: flex; gap: .8rem; flex-wrap: wrap; margin: 1rem 0; }
.verdicts div { border: 1px solid #ccc; border-radius: 6px; padding: .5rem 1rem; }
.verdicts b { font-size: 1.4rem; margin-right: .3rem; }
.v { font-weight: 600; white-space: nowrap; }
.PASS { color: #00583f; } .FAIL { color: #a33a00; } .INCONCLUSIVE, .GAVE { color: #6b5500; }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(560px, 1fr)); gap: 1.2rem;
  align-items: start; }
figure { margin: 0; border: 1px solid #ddd; border-radius: 6px; padding: .8rem; }
figure img { width: 100%; height: auto; }
figcaption b { display: block; } figcaption { color: #333; font-size: .87rem; }
table { border-collapse: collapse; font-size: .84rem; width: 100%; }
th, td { padding: .22rem .5rem; text-align: left; border-bottom: 1px solid #e4e4e4;
  vertical-align: top; }
th { position: sticky; top: 0; background: #f3f3f3; border-bottom: 2px solid #bbb; }
td.r, th.r { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.first td { border-top: 2px solid #bbb; }
details summary { cursor: pointer; color: #0b5394; white-space: nowrap; }
details div { position: absolute; right: 1.5rem; max-width: 900px; z-index: 2; background: #fff;
  border: 1px solid #999; border-radius: 6px; padding: .5rem; box-shadow: 0 2px 12px #0004; }
details table { width: auto; } details th { position: static; }
code { background: #f3f3f3; padding: .1rem .3rem; border-radius: 3px; overflow-wrap: anywhere; }
</style></head><body>
)";

std::string escape(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  // The table for terminals is ASCII; a page need not be.
  for (std::size_t at = 0; (at = result.find("+-", at)) != std::string::npos;) {
    result.replace(at, 2, "&plusmn;");
  }
  return result;
}

std::string base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

std::string verdict_span(std::string_view verdict) {
  return fmt::format("<span class=\"v {0}\">{0}</span>", verdict);
}

std::string checks_table(const CellResult& cell) {
  std::string text =
      "<table><tr><th>claim</th><th>quantity</th><th>expected</th><th>observed</th>"
      "<th>verdict</th><th>source</th></tr>";
  for (const Check& check : cell.checks) {
    text += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        escape(check.claim), escape(check.quantity), escape(check.expected), escape(check.observed),
        verdict_span(verdict_name(check.verdict)), escape(check.source));
  }
  return text + "</table>";
}

std::string summary_part(const VerifyResult& result) {
  std::size_t counts[4] = {};
  for (const CellResult& cell : result.cells) ++counts[static_cast<std::size_t>(cell.verdict())];
  for (const GrowthResult& fit : result.growths) {
    ++counts[static_cast<std::size_t>(fit.check.verdict)];
  }
  std::string text = "<div class=\"verdicts\">";
  for (const Verdict verdict :
       {Verdict::kPass, Verdict::kFail, Verdict::kInconclusive, Verdict::kGaveUp}) {
    text += fmt::format("<div><b>{}</b>{}</div>", counts[static_cast<std::size_t>(verdict)],
                        verdict_span(verdict_name(verdict)));
  }
  text += "</div>\n<p>" + escape(closing_line(result)) + "</p>\n";
  if (result.interrupted) {
    text += "<p><b>Interrupted:</b> only what was finished is here.</p>\n";
  }
  return text;
}

// What did not pass, with its reasons; nothing if all passed.
std::string trouble_part(const VerifyResult& result) {
  std::string text;
  for (const CellResult& cell : result.cells) {
    if (cell.verdict() == Verdict::kPass) continue;
    const CellRow row = cell_row(cell);
    text +=
        fmt::format("<h3>{} &middot; {} &middot; n = {} &middot; {}</h3>\n", escape(row.structure),
                    escape(row.workload), row.n, verdict_span(row.verdict));
    text += checks_table(cell);
    for (const std::string& file : cell.kept) {
      text += "<p>Scene kept: <code>" + escape(file) + "</code></p>\n";
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
  for (const GrowthResult& growth : result.growths) {
    text += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"r\">{}</td>"
        "<td class=\"r\">{}</td><td>{}</td><td>{}</td></tr>\n",
        escape(growth.claim.structure), escape(growth.claim.family), escape(growth.check.expected),
        escape(growth.check.observed), growth.points.size(),
        growth.fit ? fmt::format("{:.2f} / {}", growth.fit->chi_square, growth.fit->degrees) : "-",
        verdict_span(verdict_name(growth.check.verdict)), escape(growth.check.source));
  }
  return text +
         "</table>\n<p class=\"facts\">Intervals: 95 %, Student's t; widened where the points "
         "scatter more than their standard errors allow.</p>\n";
}

std::string plots_part(const std::vector<Figure>& figures, const Drawings& drawings) {
  std::string text = "<h2>Plots</h2>\n";
  if (!drawings.problem.empty()) {
    text += "<p><b>Not all plots could be drawn:</b> " + escape(drawings.problem) +
            ". The tables hold the same numbers.</p>\n";
  }
  text += "<div class=\"grid\">\n";
  for (std::size_t i = 0; i < figures.size() && i < drawings.svg.size(); ++i) {
    if (drawings.svg[i].empty()) continue;
    text += fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/svg+xml;base64,{1}\">"
        "<figcaption><b>{0}</b>{2}</figcaption></figure>\n",
        escape(figures[i].title), base64(drawings.svg[i]), escape(figures[i].caption));
  }
  return text + "</div>\n";
}

std::string cells_part(const VerifyResult& result) {
  std::string text =
      "<h2>All cells</h2>\n<p class=\"facts\">Events are means over the runs where there are "
      "several. "
      "Bound: the hard bound on the events. exact/double: CPU time of the simulation on the first "
      "scene; &ldquo;differs&rdquo;: doubles handled other events, so times say nothing; "
      "&ldquo;-&rdquo;: too short to be measured.</p>\n"
      "<table><tr><th>structure</th><th>workload</th><th class=\"r\">n</th><th "
      "class=\"r\">runs</th>"
      "<th class=\"r\">external</th><th class=\"r\">internal</th><th class=\"r\">bound</th>"
      "<th>expected</th><th>observed</th><th>checks</th><th class=\"r\">exact/double</th>"
      "<th>verdict</th></tr>\n";
  std::string structure;
  for (const CellResult& cell : result.cells) {
    const CellRow row = cell_row(cell);
    const bool first = row.structure != structure;
    structure = row.structure;
    text += fmt::format(
        "<tr{}><td>{}</td><td>{}</td><td class=\"r\">{}</td><td class=\"r\">{}</td>"
        "<td class=\"r\">{}</td><td class=\"r\">{}</td><td "
        "class=\"r\">{}</td><td>{}</td><td>{}</td>"
        "<td><details><summary>{}</summary><div>{}</div></details></td><td "
        "class=\"r\">{}</td><td>{}</td></tr>\n",
        first ? " class=\"first\"" : "", escape(row.structure), escape(row.workload), row.n,
        row.runs, row.external, row.internal, row.bound, escape(row.expected), escape(row.observed),
        row.checks, checks_table(cell), row.ratio, verdict_span(row.verdict));
  }
  return text + "</table>\n";
}

std::string facts_part(const PageFacts& facts) {
  const BuildFacts& build = facts.build;
  const MachineFacts& machine = facts.machine;
  return fmt::format(
      "<h2>How this was made</h2>\n<p><code>{}</code> in {:.0f} s</p>\n"
      "<p class=\"facts\">{}, commit {}{}; {}; flags {}; {}</p>\n"
      "<p class=\"facts\">{}, {} cores, {} MB, {}</p>\n",
      escape(facts.command), facts.seconds, escape(build.program), escape(build.commit),
      build.dirty ? " with changes" : "", escape(build.compiler), escape(build.flags),
      escape(build.libraries), escape(machine.cpu), machine.cores, machine.memory_kb / 1024,
      escape(machine.kernel));
}

}  // namespace

std::string verify_page(const VerifyResult& result, const std::vector<Figure>& figures,
                        const Drawings& drawings, const PageFacts& facts) {
  std::string page = kHead;
  page +=
      "<h1>kinex verify</h1>\n<p class=\"facts\">Do kinetic data structures do what their theory "
      "says? Counted in exact arithmetic, with audits by independent code.</p>\n";
  page += summary_part(result);
  page += trouble_part(result);
  page += fits_part(result);
  page += plots_part(figures, drawings);
  page += cells_part(result);
  page += facts_part(facts);
  return page + "</body></html>\n";
}

}  // namespace kinex
