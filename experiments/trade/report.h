// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as a table for people and as JSON lines for programs.
#ifndef KINEX_EXPERIMENTS_TRADE_REPORT_H
#define KINEX_EXPERIMENTS_TRADE_REPORT_H

#include <optional>
#include <string>

#include "experiments/trade/runner.h"

namespace kinex::trade {

// The columns of a run's row, as text; "-": does not apply.
struct TradeRow {
  std::string arithmetic;
  std::string time, memory;  // over `double`
  std::string missed, invented, inversions;
  std::string first;        // "12 at 0.31": number and time of the first event that differs
  std::string error, ulps;  // largest of an event time
  std::string state;        // "8/8": valid checkpoints, of all
  std::string standing;     // "same events", "other events, valid", "WRONG from t = 0.5", ..
};
TradeRow trade_row(const CaseResult& one, const TradeRun& run);

// "1.5e-17", with `digits` significant digits; "inf".
std::string short_number(double value, int digits);
// A decimal, with at most eight significant digits.
std::string short_decimal(const std::string& decimal);
// "a heading, this scene needs 71 bits, .."
std::string case_heading(const CaseResult& one);
// "needs 71 bits (99 %: 40)"; "-" without pairs of instants.
std::string bits_sentence(const BitsNeeded& bits);
// "bits = 3.9 log2(n) + 12.1, 95 % in [3.6, 4.2]"
std::string growth_text(const lab::Fit& fit);

// A heading, the table's header, a row for each arithmetic, an empty line.
std::string table_of(const CaseResult& one);
std::string bits_header();
std::string table_row(const BitsResult& one);
std::string table_row(const BitsGrowth& growth);
// "29 scenes: exact, sturm right in all of them; double in 21, gsl in 19; 3 min"; right: every state
// was valid.
std::string verdict_line(const TradeResult& result, double seconds);
// The number of cases, and of those in which each arithmetic was the same, valid, wrong.
std::string closing_lines(const TradeResult& result);

// {"row": "case", ..}, {"row": "bits", ..}, {"row": "growth", ..}, with a newline.
std::string json_row(const CaseResult& one);
std::string json_row(const BitsResult& one);
std::string json_row(const BitsGrowth& growth);

}  // namespace kinex::trade

#endif
