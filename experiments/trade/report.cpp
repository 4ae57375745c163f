// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/report.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "experiments/formats/counted.h"
#include "experiments/lab/scene_command.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

constexpr const char* kRowFormat =
    "  {:<10} {:>8} {:>8} {:>7} {:>8} {:>8} {:>19} {:>8} {:>8} {:>6}  {}\n";

std::string ratio_text(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.{}f}", *ratio, *ratio < 100 ? 2 : 0) : "-";
}

std::string standing_text(const TradeRun& run) {
  const std::string since = run.first_wrong.empty() ? "" : short_decimal(run.first_wrong);
  switch (run.ending) {
    case Ending::kEnded:
      break;
    case Ending::kCorrupt:
      return fmt::format("CORRUPT{}: {}", run.guard_fired ? ", guard" : "", run.trouble);
    case Ending::kEndless:
      return fmt::format("ENDLESS: stopped after {} log records", run.events);
    case Ending::kGaveUp:
      return "gave up at the limit of time";
    case Ending::kThrew:
      return "THREW: " + run.trouble;
  }
  if (run.differs) return "DIFFERS from exact";
  switch (run.standing()) {
    case Standing::kSame:
      return "same events";
    case Standing::kValid:
      return "other events, valid";
    case Standing::kWrong:
      return run.valid_at_end ? "WRONG at t = " + since + ", right at the end"
                              : "WRONG from t = " + since;
  }
  return "";
}

}  // namespace

std::string short_number(double value, int digits) {
  if (std::isinf(value)) return "inf";
  if (value == 0) return "0";
  return fmt::format("{:.{}g}", value, digits);
}

std::string short_decimal(const std::string& decimal) {
  return decimal.empty() ? "-" : fmt::format("{:.8g}", std::strtod(decimal.c_str(), nullptr));
}

TradeRow trade_row(const CaseResult& one, const TradeRun& run) {
  const Deviation& deviation = run.deviation;
  TradeRow row;
  row.arithmetic = run.arithmetic;
  row.time = ratio_text(one.time_ratio(run));
  row.memory = ratio_text(one.memory_ratio(run));
  row.missed = std::to_string(deviation.missed);
  row.invented = std::to_string(deviation.invented);
  row.inversions = std::to_string(deviation.inversions);
  row.first = deviation.first == 0
                  ? "-"
                  : fmt::format("{} at {}", deviation.first, short_decimal(deviation.first_time));
  row.error = short_number(deviation.error, 2);
  row.ulps = short_number(deviation.error_ulps, 2);
  row.state = fmt::format("{}/{}", run.valid, run.checkpoints);
  row.standing = standing_text(run);
  return row;
}

std::string bits_sentence(const BitsNeeded& bits) {
  if (bits.pairs == 0) return "needs no bits: nothing has to be told apart";
  return fmt::format("needs {} bits (99 %: {})", bits.most, bits.percentile_99);
}

std::string case_heading(const CaseResult& one) {
  const std::string what =
      fmt::format("{}, {}, n = {}", one.which.structure, one.which.name, one.objects);
  if (!one.problem.empty()) return what + ": " + one.problem;
  return fmt::format("{}: {} at {}; {}", what, formats::counted(one.events, "log record", "log records"),
                     formats::counted(one.bits.instants, "instant", "instants"), bits_sentence(one.bits));
}

std::string growth_text(const lab::Fit& fit) {
  return fmt::format("bits = {:.2f} log2(n) {} {:.1f}, slope 95 % in [{:.2f}, {:.2f}]", fit.b,
                     fit.a < 1 ? "-" : "+", std::fabs(std::log2(fit.a)), fit.lower, fit.upper);
}

std::string table_of(const CaseResult& one) {
  std::string text = case_heading(one) + "\n";
  if (one.runs.empty()) return text + "\n";
  text += fmt::format(fmt::runtime(kRowFormat), "arithmetic", "time/dbl", "mem/dbl", "missed",
                      "invented", "inverted", "first difference", "error/s", "ulps", "valid",
                      "outcome");
  for (const TradeRun& run : one.runs) {
    const TradeRow row = trade_row(one, run);
    text += fmt::format(fmt::runtime(kRowFormat), row.arithmetic, row.time, row.memory, row.missed,
                        row.invented, row.inversions, row.first, row.error, row.ulps, row.state,
                        row.standing);
  }
  return text + "\n";
}

std::string bits_header() {
  return fmt::format("{:<18} {:<26} {:>6} {:>6} {:>10} {:>12} {:>12}\n", "bits needed", "family",
                     "n", "scenes", "instants", "at most", "99 %");
}

std::string table_row(const BitsResult& one) {
  const auto mean = [](const lab::RunningMean& m) {
    return m.count() == 0 ? "-" : fmt::format("{:.1f} +- {:.1f}", m.mean(), m.standard_error());
  };
  return fmt::format("{:<18} {:<26} {:>6} {:>6} {:>10.0f} {:>12} {:>12}\n", one.which.structure,
                     one.which.family, one.which.parameters.n, one.which.seeds, one.instants.mean(),
                     mean(one.most), mean(one.percentile_99));
}

std::string table_row(const BitsGrowth& growth) {
  std::string text =
      fmt::format("{:<18} {:<26} {}", growth.structure, growth.family, growth_text(*growth.most));
  if (growth.percentile_99) text += fmt::format("; 99 %: {:.2f}", growth.percentile_99->b);
  return text + "\n";
}

std::string verdict_line(const TradeResult& result, double seconds) {
  std::string always, sometimes;
  for (const ArithmeticStandings& one : standings_of(result)) {
    const int right = one.cases[0] + one.cases[1], all = right + one.cases[2];
    if (right == all) {
      always += (always.empty() ? "" : ", ") + one.arithmetic;
    } else {
      sometimes +=
          fmt::format("{}{} in {}", sometimes.empty() ? "; " : ", ", one.arithmetic, right);
    }
  }
  std::string text = fmt::format("{}: {} right in all of them{}",
                                 formats::counted(result.cases.size(), "scene", "scenes"),
                                 always.empty() ? "none" : always, sometimes);
  const std::size_t faults = result.faults().size();
  if (faults > 0) text += "; " + formats::counted(faults, "fault", "faults");
  if (result.interrupted) text += "; interrupted";
  return text + "; " + lab::duration_text(seconds);
}

std::string closing_lines(const TradeResult& result) {
  std::string text =
      fmt::format("{}; same events / other events, valid / wrong:\n",
                  formats::counted(result.cases.size(), "case", "cases"));
  for (const ArithmeticStandings& one : standings_of(result)) {
    text += fmt::format("  {:<10} {:>3} / {} / {}\n", one.arithmetic, one.cases[0], one.cases[1],
                        one.cases[2]);
  }
  for (const std::string& fault : result.faults()) text += "FAIL " + fault + "\n";
  return text;
}

}  // namespace kinex::trade
