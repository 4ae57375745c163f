// SPDX-License-Identifier: GPL-3.0-or-later
// Results as JSON, for JsonWriter::value.
#ifndef KINEX_EXPERIMENTS_LAB_REPORT_JSON_H
#define KINEX_EXPERIMENTS_LAB_REPORT_JSON_H

#include "experiments/formats/json_writer.h"
#include "experiments/lab/fit.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/neighbours.h"
#include "experiments/lab/statistics.h"

namespace kinex::lab {

// {"mean", "standard_error", "smallest", "largest"}
void write_json(formats::JsonWriter& json, const RunningMean& mean);
// {"claim", "kind", "quantity"?, "expected", "observed", "verdict", "source", "seeds_needed"?}
void write_json(formats::JsonWriter& json, const Check& check);
// {"law", "exponent", "standard_error", "interval_95", "factor", "lower_order"?, "chi_square",
// "degrees_of_freedom"}; chi squared is null without standard errors.
void write_json(formats::JsonWriter& json, const Fit& fit);
// {"law", "chi_square", "scatter", "degrees_of_freedom", "consistent", "rivals": [{"law", "chi_square",
// "scatter", "lead", "outcome"}, ..]}; `lead`: chi squared, or without standard errors a ratio of
// scatters; `outcome`: outcome_word.
void write_json(formats::JsonWriter& json, const Neighbours& neighbours);

}  // namespace kinex::lab

#endif
