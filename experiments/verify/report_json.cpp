// SPDX-License-Identifier: GPL-3.0-or-later
// Results as JSON lines.
#include "experiments/formats/json_writer.h"
#include "experiments/lab/measures.h"
#include "experiments/verify/report_text.h"

namespace kinex::verify {

namespace {

void write_check(formats::JsonWriter& json, const lab::Check& check) {
  json.begin_object().key("claim").string(check.claim).key("kind").string(check.kind);
  if (!check.quantity.empty()) json.key("quantity").string(check.quantity);
  json.key("expected").string(check.expected).key("observed").string(check.observed);
  json.key("verdict").string(lab::check_word(check.verdict)).key("source").string(check.source);
  if (check.seeds_needed > 0) json.key("seeds_needed").number(check.seeds_needed);
  json.end_object();
}

void write_body_parameters(formats::JsonWriter& json, const lab::Cell& cell) {
  if (cell.parameters.m != 0) json.key("m").number(cell.parameters.m);
  if (cell.parameters.separation) {
    json.key("separation").string(cell.parameters.separation->to_string());
  }
  if (cell.parameters.turns != -1) json.key("turns").number(cell.parameters.turns);
  if (cell.turned) json.key("turned").boolean(true);
}

void write_mean(formats::JsonWriter& json, const lab::RunningMean& mean) {
  json.begin_object().key("mean").real(mean.mean());
  json.key("standard_error").real(mean.standard_error());
  json.key("smallest").real(mean.smallest()).key("largest").real(mean.largest()).end_object();
}

void write_fit(formats::JsonWriter& json, const lab::Fit& fit) {
  json.begin_object().key("law").string(fit.law).key("exponent").real(fit.b);
  json.key("standard_error").real(fit.b_error);
  json.key("interval_95").begin_array().real(fit.lower).real(fit.upper).end_array();
  json.key("factor").real(fit.a);
  if (fit.h) json.key("lower_order").real(fit.c);
  json.key("chi_square");
  if (fit.weighted) {
    json.real(fit.chi_square);
  } else {
    json.null();
  }
  json.key("degrees_of_freedom").number(fit.degrees).end_object();
}

constexpr const char* outcome_word(lab::BetterFit better) {
  return better == lab::BetterFit::kFirst    ? "beaten"
         : better == lab::BetterFit::kSecond ? "better"
                                             : "undecided";
}

// `lead`: chi squared where there are standard errors, else a ratio of scatters.
void write_neighbours(formats::JsonWriter& json, const lab::Neighbours& neighbours) {
  const auto left = [&](const lab::Fit& fit, double scatter) {
    json.key("chi_square");
    if (neighbours.weighted) {
      json.real(fit.chi_square);
    } else {
      json.null();
    }
    json.key("scatter").real(scatter);
  };
  json.begin_object().key("law").string(neighbours.law);
  left(neighbours.claimed, neighbours.scatter);
  json.key("degrees_of_freedom").number(neighbours.claimed.degrees);
  json.key("consistent").boolean(!neighbours.is_beaten()).key("rivals").begin_array();
  for (const lab::Neighbours::Rival& rival : neighbours.rivals) {
    json.begin_object().key("law").string(rival.law);
    left(rival.fit, rival.scatter);
    json.key("lead").real(rival.lead).key("outcome").string(outcome_word(rival.better));
    json.end_object();
  }
  json.end_array().end_object();
}

}  // namespace

std::string json_row(const lab::CellResult& cell) {
  const CellRow row = cell_row(cell);
  std::string text;
  formats::JsonWriter json(text);
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
      write_mean(json, lab::mean_of(cell.trials, quantity));
    }
  }
  json.key("measures");
  if (cell.trials.empty()) {
    json.null();
  } else {
    const lab::Measures m = lab::measures_of(cell);
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
  for (const lab::Check& check : cell.checks) write_check(json, check);
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

std::string json_row(const lab::StudyResult& study) {
  std::string text;
  formats::JsonWriter json(text);
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
  for (const lab::Check& check : study.checks) write_check(json, check);
  json.end_array().key("verdict").string(lab::check_word(study.verdict())).end_object();
  return text + "\n";
}

std::string json_row(const lab::GrowthResult& growth) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("row").string("growth").key("structure").string(growth.claim.structure);
  json.key("family").string(growth.claim.family).key("check");
  write_check(json, growth.check);
  const auto fit = [&](const char* name, const std::optional<lab::Fit>& one) {
    json.key(name);
    if (one) {
      write_fit(json, *one);
    } else {
      json.null();
    }
  };
  fit("fit", growth.fit);
  fit("corrected_fit", growth.corrected);
  json.key("neighbours");
  if (growth.neighbours) {
    write_neighbours(json, *growth.neighbours);
  } else {
    json.null();
  }
  json.key("points").begin_array();
  for (std::size_t i = 0; i < growth.points.size(); ++i) {
    const lab::FitPoint& point = growth.points[i];
    json.begin_object().key("n").real(point.n).key("count").real(point.count);
    json.key("standard_error").real(point.error);
    if (growth.fit) json.key("residual").real(growth.fit->residuals[i]);
    json.end_object();
  }
  json.end_array().key("verdict").string(lab::check_word(growth.check.verdict)).end_object();
  return text + "\n";
}

}  // namespace kinex::verify
