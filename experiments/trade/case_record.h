// SPDX-License-Identifier: GPL-3.0-or-later
// The state that an interrupted `kinex trade` resumes from: finished cases and bits as text, and
// back.
#ifndef KINEX_EXPERIMENTS_TRADE_CASE_RECORD_H
#define KINEX_EXPERIMENTS_TRADE_CASE_RECORD_H

#include <optional>
#include <string>

#include "experiments/trade/runner.h"

namespace kinex {

// Identifies a case by everything but the program that decides its results.
std::string case_key(const TradeCase& which, const TradeOptions& options);
std::string bits_key(const BitsCase& which);

std::string case_record(const CaseResult& result);
std::string bits_record(const BitsResult& result);
// nullopt if the text is no such record. `which`: the one of the key.
std::optional<CaseResult> read_case_record(const std::string& record, const TradeCase& which);
std::optional<BitsResult> read_bits_record(const std::string& record, const BitsCase& which);

}  // namespace kinex

#endif
