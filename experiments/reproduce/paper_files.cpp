// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproduce/paper_files.h"

#include <fmt/format.h>

#include "experiments/formats/json_writer.h"

namespace kinex::reproduce {

namespace {

void write_claim(formats::JsonWriter& json, const lab::PaperClaim& claim) {
  json.line(2).begin_object();
  const auto field = [&](const char* name, const std::string& text) {
    json.line(4).key(name).string(text);
  };
  field("id", claim.id);
  field("place", claim.place);
  field("statement", claim.statement);
  field("kind", claim.kind);
  field("command", claim.command);
  field("expected", claim.expected);
  field("tolerance", claim.tolerance);
  field("observed", claim.observed);
  field("verdict", std::string(lab::claim_word(claim.verdict)));
  json.line(4).key("assumptions").begin_array();
  for (const std::string& assumption : claim.assumptions) json.string(assumption);
  json.end_array();
  if (!claim.counterexample.empty()) field("counterexample", claim.counterexample);
  json.line(4).key("checked_by");
  lab::write_checked_by(json, claim.checked_by);
  json.line(2).end_object();
}

std::string made_by(const ReproductionFacts& facts) {
  return lab::provenance(facts.command, facts.build, facts.machine);
}

}  // namespace

std::string claims_json(const lab::Paper& paper, const std::vector<ReproducedPart>& parts,
                        const ReproductionFacts& facts) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().line(0).key("paper").string(paper.name);
  json.line(0).key("title").string(paper.title);
  json.line(0).key("made_by").string(made_by(facts));
  json.line(0).key("claims").begin_array();
  for (const ReproducedPart& part : parts) {
    for (const lab::PaperClaim& claim : part.report.claims) write_claim(json, claim);
  }
  json.line(0).end_array().line(0).end_object();
  return text + "\n";
}

std::string paper_readme(const lab::Paper& paper, const std::vector<ReproducedPart>& parts,
                         const ReproductionFacts& facts, bool drawn) {
  std::string text = fmt::format(
      "# {}\n\nMade by {}. All runs are exact, and audited where no note says otherwise.\n",
      paper.title, made_by(facts));
  for (const ReproducedPart& part : parts) {
    text += fmt::format("\n## {}: {}\n\n", part.part->name, part.part->summary);
    if (part.interrupted)
      text += "Interrupted: what follows is of the runs that were finished.\n\n";
    for (const std::string& trouble : part.troubles) text += "**Failed:** " + trouble + "\n\n";
    for (const lab::PaperClaim& claim : part.report.claims) {
      text += fmt::format(
          "- **{}** ({}, {}): {} **{}**.\n  - expected: {}; tolerance: {}\n"
          "  - observed: {}\n  - reproduce: `{}`\n",
          claim.id, claim.place, claim.kind, claim.statement, lab::claim_word(claim.verdict),
          claim.expected, claim.tolerance, claim.observed, claim.command);
      for (const std::string& assumption : claim.assumptions) {
        text += "  - assumed: " + assumption + "\n";
      }
      if (!claim.counterexample.empty()) {
        text += "  - known counterexample: " + claim.counterexample + "\n";
      }
      text += "  - checked by a second program: " + claim.checked_by.text() + "\n";
    }
    for (std::size_t i = 0; drawn && i < part.report.figures.size(); ++i) {
      text += fmt::format("\n![{}]({}.svg)\n\n{}: {}\n", part.report.figures[i].title,
                          part.report.figure_names[i], part.report.figures[i].title,
                          part.report.figures[i].caption);
    }
    if (!part.report.tables.empty()) text += "\n" + part.report.tables;
  }
  return text;
}

}  // namespace kinex::reproduce
