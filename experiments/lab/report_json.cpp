// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/report_json.h"

#include <optional>
#include <vector>

namespace kinex::lab {

void write_json(formats::JsonWriter& json, const RunningMean& mean) {
  json.object("mean", mean.mean(), "standard_error", mean.standard_error(), "smallest",
              mean.smallest(), "largest", mean.largest());
}

void write_json(formats::JsonWriter& json, const Check& check) {
  json.begin_object().members("claim", check.claim, "kind", check.kind);
  if (!check.quantity.empty()) json.members("quantity", check.quantity);
  json.members("expected", check.expected, "observed", check.observed, "verdict",
               check_word(check.verdict), "source", check.source);
  if (check.seeds_needed > 0) json.members("seeds_needed", check.seeds_needed);
  json.end_object();
}

void write_json(formats::JsonWriter& json, const Fit& fit) {
  json.begin_object().members("law", fit.law, "exponent", fit.b, "standard_error", fit.b_error,
                              "interval_95", std::vector{fit.lower, fit.upper}, "factor", fit.a);
  if (fit.h) json.members("lower_order", fit.c);
  json.members("chi_square", chi_square_of(fit), "degrees_of_freedom", fit.degrees).end_object();
}

void write_json(formats::JsonWriter& json, const Neighbours& neighbours) {
  const auto chi_square = [&](const Fit& fit) {
    return neighbours.weighted ? std::optional(fit.chi_square) : std::nullopt;
  };
  json.begin_object().members("law", neighbours.law, "chi_square", chi_square(neighbours.claimed),
                              "scatter", neighbours.scatter, "degrees_of_freedom",
                              neighbours.claimed.degrees, "consistent", !neighbours.is_beaten());
  json.key("rivals").begin_array();
  for (const Neighbours::Rival& rival : neighbours.rivals) {
    json.object("law", rival.law, "chi_square", chi_square(rival.fit), "scatter", rival.scatter,
                "lead", rival.lead, "outcome", outcome_word(rival.better));
  }
  json.end_array().end_object();
}

}  // namespace kinex::lab
