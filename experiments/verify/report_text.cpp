// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "experiments/formats/counted.h"
#include "experiments/lab/family.h"

namespace kinex::verify {

namespace {

std::string mean_count(const lab::CellResult& cell, const lab::Quantity& quantity) {
  const double mean = lab::mean_of(cell.trials, quantity).mean();
  return cell.trials.size() == 1 ? fmt::format("{:.0f}", mean) : fmt::format("{:.1f}", mean);
}

std::string ratio_text(const lab::CellResult& cell) {
  if (cell.contest && !cell.contest->same_counts) return "differs";
  const std::optional<double> ratio = exact_over_double(cell);
  return ratio ? fmt::format("{:.2f}", *ratio) : "-";
}

// Failures are explained in full; a bound that holds needs no words.
std::string explain(const lab::Check& check) {
  return fmt::format("  {} {}{}: expected {}, observed {}{}\n", lab::check_word(check.verdict),
                     check.claim, check.quantity.empty() ? "" : " " + check.quantity,
                     check.expected, check.observed,
                     check.source.empty() ? "" : " (" + check.source + ")");
}

// Which count, over which sizes, the verdict of a fit is about.
std::string decided_by(const lab::GrowthResult& growth) {
  const lab::GrowthClaim& claim = growth.claim;
  std::string text = fmt::format(
      "  {} {}: decided by the fit of {} over {}", lab::check_word(growth.check.verdict),
      claim.claim, growth.check.quantity, formats::counted(growth.points.size(), "size", "sizes"));
  if (!growth.points.empty()) {
    text += fmt::format(", {} = {} to {}", growth.axis.empty() ? "n" : growth.axis,
                        lab::number_text(growth.points.front().n, 4),
                        lab::number_text(growth.points.back().n, 4));
  }
  return text + "\n";
}

// Every check of the result.
template <class Visit>
void for_checks(const VerifyResult& result, const Visit& visit) {
  for (const lab::CellResult& cell : result.cells) {
    for (const lab::Check& check : cell.checks) visit(check);
  }
  for (const lab::GrowthResult& growth : result.growths) visit(growth.check);
  for (const lab::StudyResult& study : result.studies) {
    for (const lab::Check& check : study.checks) visit(check);
  }
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
  const auto good = std::count_if(
      cell.checks.begin(), cell.checks.end(),
      [](const lab::Check& check) { return check.verdict == lab::Verdict::kConfirmed; });
  row.checks = fmt::format("{}/{}", good, cell.checks.size());
  if (cell.trials.empty()) return row;
  const lab::Measurement& first = cell.trials.front().measurement;
  if (cell.cell.axis.is_objects()) row.n = std::to_string(first.objects);
  row.external = mean_count(cell, "external");
  row.internal = mean_count(cell, "internal");
  if (const auto bound = lab::bound_on_processed(first)) {
    row.bound = bound->to_string();
  } else if (const BoundCheck* some = lab::event_bound(first)) {
    row.bound = some->bound.to_string();
  }
  row.observed = mean_count(cell, "processed");
  if (!cell.cell.expectations.empty()) {
    row.expected = cell.checks.front().expected;
    row.observed = cell.checks.front().observed;
  }
  return row;
}

std::vector<std::string> CellRow::texts(bool bounds) const {
  std::vector<std::string> all{structure, workload, n, runs, external, internal};
  if (bounds) all.push_back(bound);
  all.insert(all.end(), {expected, observed, checks, ratio, verdict});
  return all;
}

std::vector<lab::TextColumn> cell_columns(bool bounds) {
  std::vector<lab::TextColumn> all{{"structure", -18, false}, {"workload", -30, false}, {"n", 5},
                                   {"runs", 4},               {"external", 9},          {"internal", 8}};
  if (bounds) all.push_back({"bound", 15});
  all.insert(all.end(), {{"expected", 15, false},
                         {"observed", -26, false},
                         {"checks", 6, false},
                         {"ex/dbl", 7, true, "exact/double"},
                         {"verdict", 0, false, nullptr, true}});
  return all;
}

bool shows_bounds(const std::vector<lab::Cell>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](const lab::Cell& cell) {
    const lab::FamilyExperiments* family = lab::experiments_on(cell.structure);
    return family == nullptr || family->bounds_events == nullptr ||
           family->bounds_events(cell.structure);
  });
}

std::string table_header(bool bounds) { return lab::text_header(cell_columns(bounds)); }

std::string table_legend(bool bounds) {
  return std::string("external, internal  events; means over the runs, where there are several\n") +
         (bounds ? "bound     the hard bound on the events, a theorem that no run may exceed; "
                   "where there is none on\n"
                   "          all of them, that on those of one structure; - is none\n"
                 : "") +
         "expected  what is claimed, by a proof or an independent count; of several claims the "
         "first; - is none\n"
         "observed  what was counted of it; of a row without a claim all events, external and "
         "internal\n"
         "checks    those that hold, of all: the claims, every hard bound, audits\n"
         "ex/dbl    CPU time in exact arithmetic over that in doubles, of the first scene; "
         "differs: doubles had\n"
         "          other events; -: too short to be measured\n\n";
}

std::string table_row(const lab::CellResult& cell, bool bounds) {
  std::string text = lab::text_row(cell_columns(bounds), cell_row(cell).texts(bounds));
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
  if (growth.check.verdict != lab::Verdict::kConfirmed) text += decided_by(growth);
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
  for_checks(result, [&](const lab::Check& check) {
    open += check.seeds_needed > 0 ? 1 : 0;
    needed = std::max(needed, check.seeds_needed);
  });
  if (open == 0) return "";
  return fmt::format(
      "Too few random scenes to tell for {}: --seeds {} would do, or about so many; without --seeds "
      "every experiment takes as many as it needs\n",
      formats::counted(open, "check", "checks"), needed);
}

std::string verdict_line(const VerifyResult& result, const lab::TimeTaken& taken) {
  std::array<std::size_t, 5> counts{};  // of cells, fits and studies, by verdict
  const auto count = [&](lab::Verdict verdict) -> std::size_t& {
    return counts[static_cast<std::size_t>(verdict)];
  };
  for (const lab::CellResult& cell : result.cells) ++count(cell.verdict());
  for (const lab::GrowthResult& growth : result.growths) ++count(growth.check.verdict);
  for (const lab::StudyResult& study : result.studies) ++count(study.verdict());
  const std::size_t held = count(lab::Verdict::kConfirmed), failed = count(lab::Verdict::kRefuted);
  std::string text = fmt::format("{} of {} hold{}; {} fail{}", held,
                                 std::accumulate(counts.begin(), counts.end(), std::size_t{0}),
                                 held == 1 ? "s" : "", failed, failed == 1 ? "s" : "");
  const auto add = [&](lab::Verdict verdict, const char* words) {
    if (count(verdict) > 0) text += fmt::format("; {} {}", count(verdict), words);
  };
  add(lab::Verdict::kAgrees, count(lab::Verdict::kAgrees) == 1
                                 ? "agrees, of fewer sizes than its claim asks for"
                                 : "agree, of fewer sizes than their claims ask for");
  add(lab::Verdict::kOpen, "inconclusive");
  add(lab::Verdict::kGaveUp, "gave up");
  if (result.interrupted) text += "; interrupted";
  return text + "; " + lab::duration_text(taken);
}

std::string work_line(const VerifyResult& result) {
  std::size_t checks = 0, runs = 0;
  std::uint64_t failures = 0;
  for_checks(result, [&](const lab::Check&) { ++checks; });
  for (const lab::CellResult& cell : result.cells) {
    runs += cell.trials.size();
    for (const lab::Trial& trial : cell.trials) failures += trial.measurement.run.events;
  }
  std::string what = formats::counted(result.cells.size(), "cell", "cells");
  const std::string fits = formats::counted(result.growths.size(), "fit", "fits");
  what += result.studies.empty()
              ? " and " + fits
              : ", " + fits + " and " + formats::counted(result.studies.size(), "study", "studies");
  return fmt::format("{}: {}, {}, {}", what, formats::counted(checks, "check", "checks"),
                     formats::counted(runs, "run", "runs"),
                     formats::counted(failures, "certificate failure", "certificate failures"));
}

std::vector<lab::Table> more_tables(const VerifyResult& result) {
  std::vector<lab::FittedLaws> fitted;
  for (const lab::GrowthResult& growth : result.growths) {
    if (!growth.neighbours) continue;
    fitted.push_back({growth.claim.structure + ", " + growth.claim.family, growth.points.size(),
                      *growth.neighbours});
  }
  std::vector<lab::Table> tables = lab::family_tables(result.cells);
  if (!fitted.empty()) tables.insert(tables.begin(), lab::neighbours_table(fitted));
  return tables;
}

}  // namespace kinex::verify
