// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "experiments/formats/counted.h"
#include "experiments/lab/family.h"

namespace kinex {

namespace {

std::string row_text(const CellRow& row, bool bounds) {
  const std::string bound = bounds ? fmt::format("{:>15} ", row.bound) : "";
  return fmt::format("{:<18} {:<30} {:>5} {:>4} {:>9} {:>8} {}{:>15} {:<26} {:>6} {:>7}  {}\n",
                     row.structure, row.workload, row.n, row.runs, row.external, row.internal,
                     bound, row.expected, row.observed, row.checks, row.ratio, row.verdict);
}

std::string mean_count(const CellResult& cell, const Quantity& quantity) {
  const double mean = mean_of(cell.trials, quantity).mean();
  return cell.trials.size() == 1 ? fmt::format("{:.0f}", mean) : fmt::format("{:.1f}", mean);
}

std::string ratio_text(const CellResult& cell) {
  if (!cell.contest) return "-";
  if (!cell.contest->same_counts) return "differs";
  if (!cell.contest->ratio) return "-";
  return fmt::format("{:.2f}", *cell.contest->ratio);
}

// Failures are explained in full; a bound that holds needs no words.
std::string explain(const Check& check) {
  return fmt::format("  {} {} {}: expected {}, observed {}{}\n", check_word(check.verdict),
                     check.claim, check.quantity, check.expected, check.observed,
                     check.source.empty() ? "" : " (" + check.source + ")");
}

}  // namespace

CellRow cell_row(const CellResult& cell) {
  CellRow row;
  row.structure = cell.cell.structure;
  row.workload = cell.cell.workload_text();
  row.n = std::to_string(cell.cell.parameters.n);
  row.runs = std::to_string(cell.trials.size());
  row.verdict = check_word(cell.verdict());
  row.ratio = ratio_text(cell);
  row.bound = row.expected = row.observed = row.external = row.internal = "-";
  std::size_t good = 0;
  for (const Check& check : cell.checks) good += check.verdict == Verdict::kConfirmed ? 1 : 0;
  row.checks = fmt::format("{}/{}", good, cell.checks.size());
  if (cell.trials.empty()) return row;
  if (cell.cell.variable == Variable::kObjects) {
    row.n = std::to_string(cell.trials.front().measurement.objects);
  }
  row.external = mean_count(cell, "external");
  row.internal = mean_count(cell, "internal");
  if (const BoundCheck* bound = event_bound(cell.trials.front().measurement)) {
    row.bound = bound->bound.to_string();
  }
  row.observed = mean_count(cell, "processed");
  if (!cell.cell.expectations.empty()) {
    row.expected = cell.checks.front().expected;
    row.observed = cell.checks.front().observed;
  }
  return row;
}

bool shows_bounds(const std::vector<Cell>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](const Cell& cell) {
    const FamilyExperiments* family = experiments_on(cell.structure);
    return family == nullptr || family->bounds_events == nullptr ||
           family->bounds_events(cell.structure);
  });
}

std::string table_header(bool bounds) {
  CellRow row;
  row.structure = "structure";
  row.workload = "workload";
  row.n = "n";
  row.runs = "runs";
  row.external = "external";
  row.internal = "internal";
  row.bound = "bound";
  row.expected = "expected";
  row.observed = "observed";
  row.checks = "checks";
  row.ratio = "ex/dbl";
  row.verdict = "verdict";
  return row_text(row, bounds);
}

std::string table_row(const CellResult& cell, bool bounds) {
  std::string text = row_text(cell_row(cell), bounds);
  for (const Check& check : cell.checks) {
    if (check.verdict != Verdict::kConfirmed) text += explain(check);
  }
  for (const std::string& file : cell.kept) text += "  kept: " + file + "\n";
  return text;
}

std::string table_row(const GrowthResult& growth) {
  return fmt::format("{:<18} {:<30} expected {}, fitted {}  {}\n", growth.claim.structure,
                     "growth, " + growth.claim.family, growth.check.expected, growth.check.observed,
                     check_word(growth.check.verdict));
}

std::string table_row(const StudyResult& study) {
  std::string text;
  for (const Check& check : study.checks) {
    text += fmt::format("{:<18} {:<30} expected {}, observed {}  {}\n", study.name, check.claim,
                        check.expected, check.observed, check_word(check.verdict));
  }
  return text;
}

std::string seeds_line(const VerifyResult& result) {
  std::size_t open = 0;
  int needed = 0;
  const auto look = [&](const Check& check) {
    open += check.seeds_needed > 0 ? 1 : 0;
    needed = std::max(needed, check.seeds_needed);
  };
  for (const CellResult& cell : result.cells) {
    for (const Check& check : cell.checks) look(check);
  }
  for (const GrowthResult& growth : result.growths) look(growth.check);
  if (open == 0) return "";
  return fmt::format(
      "Too few random scenes to tell for {} check{}: --seeds {} would do, or about so many; "
      "without "
      "--seeds every experiment takes as many as it needs\n",
      open, open == 1 ? "" : "s", needed);
}

std::string closing_line(const VerifyResult& result) {
  std::array<std::size_t, 4> by_verdict{};
  std::size_t checks = result.growths.size(), runs = 0;
  std::uint64_t failures = 0;
  for (const CellResult& cell : result.cells) {
    ++by_verdict[static_cast<std::size_t>(cell.verdict())];
    checks += cell.checks.size();
    runs += cell.trials.size();
    for (const Trial& trial : cell.trials) failures += trial.measurement.run.events;
  }
  for (const GrowthResult& growth : result.growths) {
    ++by_verdict[static_cast<std::size_t>(growth.check.verdict)];
  }
  for (const StudyResult& study : result.studies) {
    checks += study.checks.size();
    ++by_verdict[static_cast<std::size_t>(study.verdict())];
  }
  std::string text = fmt::format("{} and {}:", counted(result.cells.size(), "cell", "cells"),
                                 counted(result.growths.size(), "fit", "fits"));
  if (!result.studies.empty()) {
    text = fmt::format("{}, {} and {}:", counted(result.cells.size(), "cell", "cells"),
                       counted(result.growths.size(), "fit", "fits"),
                       counted(result.studies.size(), "study", "studies"));
  }
  for (const Verdict verdict :
       {Verdict::kConfirmed, Verdict::kOpen, Verdict::kGaveUp, Verdict::kRefuted}) {
    text += fmt::format("{} {} {}", verdict == Verdict::kConfirmed ? "" : ",",
                        by_verdict[static_cast<std::size_t>(verdict)], check_word(verdict));
  }
  text += fmt::format("; {}, {}, {}\n", counted(checks, "check", "checks"),
                      counted(runs, "run", "runs"),
                      counted(failures, "certificate failure", "certificate failures"));
  return text + seeds_line(result);
}

}  // namespace kinex
