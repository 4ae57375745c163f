// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/report_text.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "experiments/formats/counted.h"
#include "experiments/formats/plain_text.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

constexpr lab::TextColumn kRunColumns[] = {
    {"arithmetic", -10, false},
    {"time/dbl", 8, true, "time / double"},
    {"mem/dbl", 8, true, "memory / double"},
    {"missed", 7},
    {"invented", 8},
    {"inverted", 8, true, "inversions"},
    {"first difference", 19, false, "first difference: event, time"},
    {"error/s", 8, true, "error, s"},
    {"ulps", 8, true, "error, ulps"},
    {"valid", 6, true, "valid states"},
    {"outcome", 0, false, nullptr, true}};
constexpr lab::TextColumn kBitsColumns[] = {{"bits needed", -18, false}, {"family", -26, false},
                                            {"n", 6},                    {"scenes", 6},
                                            {"instants", 10},            {"at most", 12},
                                            {"99 %", 12}};

std::string ratio_text(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.{}f}", *ratio, *ratio < 100 ? 2 : 0) : "-";
}

std::string outcome_text(const TradeRun& run) {
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
      break;
  }
  const std::string since = short_time(run.first_wrong);
  return run.valid_at_end ? "WRONG at t = " + since + ", right at the end"
                          : "WRONG from t = " + since;
}

std::string bits_sentence(const BitsNeeded& bits) {
  if (bits.pairs == 0) return "needs no bits: nothing has to be told apart";
  return fmt::format("needs {} (99 %: {})",
                     formats::counted(static_cast<std::uint64_t>(bits.most), "bit", "bits"),
                     bits.percentile_99);
}

}  // namespace

std::string short_number(double value, int digits) {
  if (std::isinf(value)) return "inf";
  if (value == 0) return "0";
  return fmt::format("{:.{}g}", value, digits);
}

std::string short_time(const std::optional<Rational>& time) {
  return time ? fmt::format("{:.8g}", time->to_double()) : "-";
}

std::string first_text(const Deviation& deviation) {
  if (deviation.first == 0) return "-";
  return fmt::format("{} at {}", deviation.first, short_time(deviation.first_time));
}

std::span<const lab::TextColumn> run_columns() { return kRunColumns; }

std::vector<std::string> run_texts(const CaseResult& one, const TradeRun& run) {
  const Deviation& deviation = run.deviation;
  return {run.arithmetic,
          ratio_text(one.time_ratio(run)),
          ratio_text(one.memory_ratio(run)),
          std::to_string(deviation.missed),
          std::to_string(deviation.invented),
          std::to_string(deviation.inversions),
          first_text(deviation),
          short_number(deviation.error, 2),
          short_number(deviation.error_ulps, 2),
          fmt::format("{}/{}", run.valid, run.checkpoints),
          outcome_text(run)};
}

std::string case_heading(const CaseResult& one) {
  const std::string what =
      fmt::format("{}, {}, n = {}", formats::plain(one.which.structure), formats::plain(one.which.name), one.objects);
  if (!one.problem.empty()) return what + ": " + one.problem;
  return fmt::format("{}: {} at {}; {}", what, formats::counted(one.events, "log record", "log records"),
                     formats::counted(one.bits.instants, "instant", "instants"),
                     bits_sentence(one.bits));
}

std::string growth_text(const lab::Fit& fit) {
  return fmt::format("bits = {:.2f} log2(n) {} {:.1f}, slope 95 % in [{:.2f}, {:.2f}]", fit.b,
                     fit.a < 1 ? "-" : "+", std::fabs(std::log2(fit.a)), fit.lower, fit.upper);
}

std::string table_of(const CaseResult& one) {
  std::string text = case_heading(one) + "\n";
  if (!one.runs.empty()) text += "  " + lab::text_header(kRunColumns);
  for (const TradeRun& run : one.runs) text += "  " + lab::text_row(kRunColumns, run_texts(one, run));
  return text + "\n";
}

std::string bits_header() { return lab::text_header(kBitsColumns); }

std::string table_row(const BitsResult& one) {
  const auto mean = [](const lab::RunningMean& m) {
    return m.count() == 0 ? "-" : fmt::format("{:.1f} +- {:.1f}", m.mean(), m.standard_error());
  };
  return lab::text_row(kBitsColumns,
                       {one.which.structure, one.which.family, std::to_string(one.which.parameters.n),
                        std::to_string(one.which.seeds), fmt::format("{:.0f}", one.instants.mean()),
                        mean(one.most), mean(one.percentile_99)});
}

std::string table_row(const BitsGrowth& growth) {
  std::string text =
      fmt::format("{:<18} {:<26} {}", growth.structure, growth.family, growth_text(*growth.most));
  if (growth.percentile_99) text += fmt::format("; 99 %: {:.2f}", growth.percentile_99->b);
  return text + "\n";
}

namespace {

// "3 scenes", or "3 structures of 1 scene" where a file has several.
std::string cases_text(const TradeResult& result) {
  std::set<std::string> files;
  std::size_t made = 0;
  for (const CaseResult& one : result.cases) {
    if (one.which.given == nullptr) {
      ++made;
    } else {
      files.insert(one.which.name);
    }
  }
  const std::size_t scenes = made + files.size();
  const std::string text = formats::counted(scenes, "scene", "scenes");
  if (scenes == result.cases.size()) return text;
  return formats::counted(result.cases.size(), "structure", "structures") + " of " + text;
}

}  // namespace

std::string verdict_line(const TradeResult& result, const lab::TimeTaken& taken) {
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
  std::string text =
      fmt::format("{}: {} right in {}{}", cases_text(result), always.empty() ? "none" : always,
                  result.cases.size() == 1 ? "it" : "all of them", sometimes);
  const std::size_t faults = result.faults().size();
  if (faults > 0) text += "; " + formats::counted(faults, "fault", "faults");
  if (result.interrupted) text += "; interrupted";
  return text + "; " + lab::duration_text(taken);
}

std::string closing_lines(const TradeResult& result) {
  std::string text =
      fmt::format("{}; same events / other events, valid / wrong:\n", cases_text(result));
  for (const ArithmeticStandings& one : standings_of(result)) {
    text += fmt::format("  {:<10} {:>3} / {} / {}\n", one.arithmetic, one.cases[0], one.cases[1],
                        one.cases[2]);
  }
  for (const std::string& fault : result.faults()) text += "FAIL " + fault + "\n";
  return text;
}

}  // namespace kinex::trade
