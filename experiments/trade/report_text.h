// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as a table for people and as JSON lines for programs.
#ifndef KINEX_EXPERIMENTS_TRADE_REPORT_TEXT_H
#define KINEX_EXPERIMENTS_TRADE_REPORT_TEXT_H

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/lab/table.h"
#include "experiments/lab/time_taken.h"
#include "experiments/trade/runner.h"

namespace kinex::trade {

// The columns of a run, and its cells as text; "-": does not apply. The last one is its outcome:
// "same events", "other events, valid", "WRONG from t = 0.5", ..
std::span<const lab::TextColumn> run_columns();
std::vector<std::string> run_texts(const CaseResult& one, const TradeRun& run);

// "1.5e-17", with `digits` significant digits; "inf".
std::string short_number(double value, int digits);
// With at most eight significant digits; "-": none.
std::string short_time(const std::optional<Rational>& time);
// "12 at 0.31": number and time of the first event that differs; "-": none.
std::string first_text(const Deviation& deviation);
// "a heading, this scene needs 71 bits, .."
std::string case_heading(const CaseResult& one);
// "bits = 3.9 log2(n) + 12.1, 95 % in [3.6, 4.2]"
std::string growth_text(const lab::Fit& fit);

// A heading, the table's header, a row for each arithmetic, an empty line.
std::string table_of(const CaseResult& one);
std::string bits_header();
std::string table_row(const BitsResult& one);
std::string table_row(const BitsGrowth& growth);
// "29 scenes: exact, sturm right in all of them; double in 21, gsl in 19; 3 min"; right: every state
// was valid.
std::string verdict_line(const TradeResult& result, const lab::TimeTaken& taken);
// The number of cases, and of those in which each arithmetic was the same, valid, wrong.
std::string closing_lines(const TradeResult& result);

// {"row": "case", ..}, {"row": "bits", ..}, {"row": "growth", ..}, with a newline.
std::string json_row(const CaseResult& one);
std::string json_row(const BitsResult& one);
std::string json_row(const BitsGrowth& growth);

}  // namespace kinex::trade

#endif
