// SPDX-License-Identifier: GPL-3.0-or-later
// Reports and records of cells of experiments, from and to the fields of their results.
#ifndef KINEX_EXPERIMENTS_SWEEP_FIELDS_REPORT_H
#define KINEX_EXPERIMENTS_SWEEP_FIELDS_REPORT_H

#include <optional>

#include "experiments/lab/field_archive.h"
#include "experiments/sweep/record.h"

namespace kinex::sweep {

CellReport report_of(Outcome outcome, std::string message, const lab::Fields& fields);
// nullopt: the record has none.
std::optional<lab::Fields> fields_of(const Record& record);

}  // namespace kinex::sweep

#endif
