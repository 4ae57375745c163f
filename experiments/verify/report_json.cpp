// SPDX-License-Identifier: GPL-3.0-or-later
// Results as JSON lines.
#include "experiments/formats/json_writer.h"
#include "experiments/lab/measures.h"
#include "experiments/verify/report_text.h"

namespace kinex {

namespace {

void write_check(JsonWriter& json, const Check& check) {
  json.begin_object().key("claim").string(check.claim).key("kind").string(check.kind);
  if (!check.quantity.empty()) json.key("quantity").string(check.quantity);
  json.key("expected").string(check.expected).key("observed").string(check.observed);
  json.key("verdict").string(check_word(check.verdict)).key("source").string(check.source);
  if (check.seeds_needed > 0) json.key("seeds_needed").number(check.seeds_needed);
  json.end_object();
}

void write_body_parameters(JsonWriter& json, const Cell& cell) {
  if (cell.parameters.m != 0) json.key("m").number(cell.parameters.m);
  if (cell.parameters.separation) {
    json.key("separation").string(cell.parameters.separation->to_string());
  }
  if (cell.parameters.turns != -1) json.key("turns").number(cell.parameters.turns);
  if (cell.turned) json.key("turned").boolean(true);
}

void write_mean(JsonWriter& json, const RunningMean& mean) {
  json.begin_object().key("mean").real(mean.mean());
  json.key("standard_error").real(mean.standard_error());
  json.key("smallest").real(mean.smallest()).key("largest").real(mean.largest()).end_object();
}

}  // namespace

std::string json_row(const CellResult& cell) {
  const CellRow row = cell_row(cell);
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("row").string("cell").key("structure").string(cell.cell.structure);
  json.key("workload").string(cell.cell.workload);
  json.key("parameters").begin_object().key("n").number(cell.cell.parameters.n);
  json.key("degree").number(cell.cell.parameters.degree);
  json.key("dimension").number(cell.cell.parameters.dimension);
  json.key("first_seed").number(cell.cell.parameters.seed);
  write_body_parameters(json, cell.cell);
  json.key("mirrored").boolean(cell.cell.mirrored).end_object();
  json.key("objects").raw(row.n).key("runs").raw(row.runs);
  for (const char* quantity : {"processed", "external", "internal"}) {
    json.key(quantity);
    if (cell.trials.empty()) {
      json.null();
    } else {
      write_mean(json, mean_of(cell.trials, quantity));
    }
  }
  json.key("measures");
  if (cell.trials.empty()) {
    json.null();
  } else {
    const Measures m = measures_of(cell);
    json.begin_object().key("changes").real(m.external);
    json.key("most_certificates_changed").number(m.most_changed);
    json.key("mean_certificates_changed").real(m.mean_changed);
    json.key("certificates_per_object").number(m.per_object);
    json.key("certificates").number(m.certificates).end_object();
  }
  json.key("bound");
  if (row.bound == "-") {
    json.null();
  } else {
    json.string(row.bound);
  }
  json.key("checks").begin_array();
  for (const Check& check : cell.checks) write_check(json, check);
  json.end_array().key("verdict").string(row.verdict);
  json.key("exact_over_double");
  if (cell.contest && cell.contest->ratio) {
    json.real(*cell.contest->ratio);
  } else {
    json.null();
  }
  json.key("double_agrees").boolean(cell.contest && cell.contest->same_counts);
  json.key("kept").begin_array();
  for (const std::string& file : cell.kept) json.string(file);
  json.end_array().key("seconds").real(cell.seconds).end_object();
  return text + "\n";
}

std::string json_row(const StudyResult& study) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("row").string("study").key("study").string(study.name);
  json.key("title").string(study.table.title).key("header").begin_array();
  for (const std::string& cell : study.table.header) json.string(cell);
  json.end_array().key("rows").begin_array();
  for (const auto& row : study.table.rows) {
    json.begin_array();
    for (const std::string& cell : row) json.string(cell);
    json.end_array();
  }
  json.end_array().key("checks").begin_array();
  for (const Check& check : study.checks) write_check(json, check);
  json.end_array().key("verdict").string(check_word(study.verdict())).end_object();
  return text + "\n";
}

std::string json_row(const GrowthResult& growth) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("row").string("growth").key("structure").string(growth.claim.structure);
  json.key("family").string(growth.claim.family).key("check");
  write_check(json, growth.check);
  json.key("fit");
  if (growth.fit) {
    const Fit& fit = *growth.fit;
    json.begin_object().key("exponent").real(fit.b);
    json.key("standard_error").real(fit.b_error);
    json.key("interval_95").begin_array().real(fit.lower).real(fit.upper).end_array();
    json.key("factor").real(fit.a).key("chi_square");
    if (fit.weighted) {
      json.real(fit.chi_square);
    } else {
      json.null();
    }
    json.key("degrees_of_freedom").number(fit.degrees).end_object();
  } else {
    json.null();
  }
  json.key("points").begin_array();
  for (std::size_t i = 0; i < growth.points.size(); ++i) {
    const FitPoint& point = growth.points[i];
    json.begin_object().key("n").real(point.n).key("count").real(point.count);
    json.key("standard_error").real(point.error);
    if (growth.fit) json.key("residual").real(growth.fit->residuals[i]);
    json.end_object();
  }
  json.end_array().key("verdict").string(check_word(growth.check.verdict)).end_object();
  return text + "\n";
}

}  // namespace kinex
