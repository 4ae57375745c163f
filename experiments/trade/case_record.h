// SPDX-License-Identifier: GPL-3.0-or-later
// Finished cases and bits as text, and back: what a record of them holds.
#ifndef KINEX_EXPERIMENTS_TRADE_CASE_RECORD_H
#define KINEX_EXPERIMENTS_TRADE_CASE_RECORD_H

#include <optional>

#include "experiments/lab/field_archive.h"
#include "experiments/trade/runner.h"

namespace kinex::trade {

lab::Fields case_fields_of(const CaseResult& result);
lab::Fields bits_fields_of(const BitsResult& result);
// nullopt if the texts are not of such a result. `which`: what was run.
std::optional<CaseResult> case_of(const lab::Fields& fields, const TradeCase& which);
std::optional<BitsResult> bits_of(const lab::Fields& fields, const BitsCase& which);

}  // namespace kinex::trade

#endif
