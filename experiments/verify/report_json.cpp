// SPDX-License-Identifier: GPL-3.0-or-later
// Results as JSON lines.
#include <optional>

#include "experiments/lab/measures.h"
#include "experiments/lab/report_json.h"
#include "experiments/verify/report_text.h"

namespace kinex::verify {

std::optional<double> exact_over_double(const lab::CellResult& cell) {
  return cell.contest && cell.contest->same_counts ? cell.contest->ratio : std::nullopt;
}

std::string parameters_json(const lab::CellResult& cell, bool seeds) {
  const lab::Cell& of = cell.cell;
  const lab::WorkloadParameters& parameters = of.parameters;
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().members("n", parameters.n, "degree", parameters.degree, "dimension",
                              parameters.dimension, "first_seed", parameters.seed);
  if (seeds) json.members("seeds", cell.trials.size());
  if (parameters.m != 0) json.members("m", parameters.m);
  if (parameters.separation) json.members("separation", parameters.separation->to_string());
  if (parameters.turns != -1) json.members("turns", parameters.turns);
  if (of.change != nullptr) json.members(of.change->name, true);
  json.members("mirrored", of.mirrored).end_object();
  return text;
}

std::string json_row(const lab::CellResult& cell) {
  const CellRow row = cell_row(cell);
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().members("row", "cell", "structure", cell.cell.structure, "workload",
                              cell.cell.workload);
  json.key("parameters").raw(parameters_json(cell, false));
  json.key("objects").raw(row.n).key("runs").raw(row.runs);
  const bool any = !cell.trials.empty();
  for (const char* quantity : {"processed", "external", "internal"}) {
    json.key(quantity);
    any ? json.value(lab::mean_of(cell.trials, quantity)) : json.null();
  }
  json.key("measures");
  if (any) {
    const lab::Measures m = lab::measures_of(cell);
    json.object("changes", m.external, "most_certificates_changed", m.most_changed,
                "mean_certificates_changed", m.mean_changed, "certificates_per_object", m.per_object,
                "certificates", m.certificates);
  } else {
    json.null();
  }
  json.members("bound", row.bound == "-" ? std::nullopt : std::optional(row.bound), "checks",
               cell.checks, "verdict", row.verdict, "exact_over_double", exact_over_double(cell),
               "double_agrees", cell.contest && cell.contest->same_counts, "kept", cell.kept,
               "seconds", cell.seconds);
  json.end_object();
  return text + "\n";
}

std::string json_row(const lab::StudyResult& study) {
  std::string text;
  formats::JsonWriter json(text);
  json.object("row", "study", "study", study.name, "title", study.table.title, "header",
              study.table.header, "rows", study.table.rows, "checks", study.checks, "verdict",
              lab::check_word(study.verdict()));
  return text + "\n";
}

std::string json_row(const lab::GrowthResult& growth) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().members("row", "growth", "structure", growth.claim.structure, "family",
                              growth.claim.family, "check", growth.check, "fit", growth.fit,
                              "corrected_fit", growth.corrected, "neighbours", growth.neighbours);
  json.key("points").begin_array();
  for (std::size_t i = 0; i < growth.points.size(); ++i) {
    const lab::FitPoint& point = growth.points[i];
    json.begin_object().members("n", point.n, "count", point.count, "standard_error", point.error);
    if (growth.fit) json.members("residual", growth.fit->residuals[i]);
    json.end_object();
  }
  json.end_array().members("verdict", lab::check_word(growth.check.verdict)).end_object();
  return text + "\n";
}

}  // namespace kinex::verify
