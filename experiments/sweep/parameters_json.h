// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of a workload in the text of an experiment's cell, and back.
#ifndef KINEX_EXPERIMENTS_SWEEP_PARAMETERS_JSON_H
#define KINEX_EXPERIMENTS_SWEEP_PARAMETERS_JSON_H

#include "experiments/formats/json_node.h"
#include "experiments/formats/json_writer.h"
#include "experiments/lab/workload.h"

namespace kinex::sweep {

// Members n, seed, degree, dimension; m, separation and turns where they are given.
void write_parameters(formats::JsonWriter& json, const lab::WorkloadParameters& parameters);
// Throws InputError.
lab::WorkloadParameters read_parameters(const formats::JsonNode& node);

}  // namespace kinex::sweep

#endif
