// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/report_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/lab/family.h"

namespace kinex::verify {

namespace {

std::string row_text(const CellRow& row, bool bounds) {
  const std::string bound = bounds ? fmt::format("{:>15} ", row.bound) : "";
  return fmt::format("{:<18} {:<30} {:>5} {:>4} {:>9} {:>8} {}{:>15} {:<26} {:>6} {:>7}  {}\n",
                     row.structure, row.workload, row.n, row.runs, row.external, row.internal,
                     bound, row.expected, row.observed, row.checks, row.ratio, row.verdict);
}

std::string mean_count(const lab::CellResult& cell, const lab::Quantity& quantity) {
  const double mean = lab::mean_of(cell.trials, quantity).mean();
  return cell.trials.size() == 1 ? fmt::format("{:.0f}", mean) : fmt::format("{:.1f}", mean);
}

std::string ratio_text(const lab::CellResult& cell) {
  if (!cell.contest) return "-";
  if (!cell.contest->same_counts) return "differs";
  if (!cell.contest->ratio) return "-";
  return fmt::format("{:.2f}", *cell.contest->ratio);
}

// Failures are explained in full; a bound that holds needs no words.
std::string explain(const lab::Check& check) {
  return fmt::format("  {} {} {}: expected {}, observed {}{}\n", lab::check_word(check.verdict),
                     check.claim, check.quantity, check.expected, check.observed,
                     check.source.empty() ? "" : " (" + check.source + ")");
}

}  // namespace

CellRow cell_row(const lab::CellResult& cell) {
  CellRow row;
  row.structure = cell.cell.structure;
  row.workload = cell.cell.workload_text();
  row.n = std::to_string(cell.cell.parameters.n);
  row.runs = std::to_string(cell.trials.size());
  row.verdict = lab::check_word(cell.verdict());
  row.ratio = ratio_text(cell);
  row.bound = row.expected = row.observed = row.external = row.internal = "-";
  std::size_t good = 0;
  for (const lab::Check& check : cell.checks) good += check.verdict == lab::Verdict::kConfirmed ? 1 : 0;
  row.checks = fmt::format("{}/{}", good, cell.checks.size());
  if (cell.trials.empty()) return row;
  if (cell.cell.variable == lab::Variable::kObjects) {
    row.n = std::to_string(cell.trials.front().measurement.objects);
  }
  row.external = mean_count(cell, "external");
  row.internal = mean_count(cell, "internal");
  if (const BoundCheck* bound = lab::event_bound(cell.trials.front().measurement)) {
    row.bound = bound->bound.to_string();
  }
  row.observed = mean_count(cell, "processed");
  if (!cell.cell.expectations.empty()) {
    row.expected = cell.checks.front().expected;
    row.observed = cell.checks.front().observed;
  }
  return row;
}

bool shows_bounds(const std::vector<lab::Cell>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](const lab::Cell& cell) {
    const lab::FamilyExperiments* family = lab::experiments_on(cell.structure);
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

std::string table_row(const lab::CellResult& cell, bool bounds) {
  std::string text = row_text(cell_row(cell), bounds);
  for (const lab::Check& check : cell.checks) {
    if (check.verdict != lab::Verdict::kConfirmed) text += explain(check);
  }
  for (const std::string& file : cell.kept) text += "  kept: " + file + "\n";
  return text;
}

std::string table_row(const lab::GrowthResult& growth) {
  std::string text =
      fmt::format("{:<18} {:<30} expected {}, fitted {}  {}\n", growth.claim.structure,
                  "growth, " + growth.claim.family, growth.check.expected, growth.check.observed,
                  lab::check_word(growth.check.verdict));
  if (growth.neighbours) text += "  " + lab::neighbours_text(*growth.neighbours) + "\n";
  return text;
}

std::string table_row(const lab::StudyResult& study) {
  std::string text;
  for (const lab::Check& check : study.checks) {
    text += fmt::format("{:<18} {:<30} expected {}, observed {}  {}\n", study.name, check.claim,
                        check.expected, check.observed, lab::check_word(check.verdict));
  }
  return text;
}

std::string seeds_line(const VerifyResult& result) {
  std::size_t open = 0;
  int needed = 0;
  const auto look = [&](const lab::Check& check) {
    open += check.seeds_needed > 0 ? 1 : 0;
    needed = std::max(needed, check.seeds_needed);
  };
  for (const lab::CellResult& cell : result.cells) {
    for (const lab::Check& check : cell.checks) look(check);
  }
  for (const lab::GrowthResult& growth : result.growths) look(growth.check);
  if (open == 0) return "";
  return fmt::format(
      "Too few random scenes to tell for {} check{}: --seeds {} would do, or about so many; "
      "without "
      "--seeds every experiment takes as many as it needs\n",
      open, open == 1 ? "" : "s", needed);
}

}  // namespace kinex::verify
