// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/cell_source.h"

#include <chrono>
#include <exception>
#include <utility>

#include "experiments/sweep/sweeper.h"

namespace kinex::sweep {

namespace {

std::optional<Record> run_in_child(const PlanCell& cell, const CellSource& source) {
  std::optional<Record> found;
  SweepOptions running;
  running.program = source.program;
  running.go_on = source.go_on;
  running.on_end = [&](std::size_t, const Record& record) { found = record; };
  run_cells({cell}, running);
  return found;
}

std::optional<Record> run_here(const PlanCell& cell,
                               const std::function<std::optional<CellReport>()>& here) {
  const auto begin = std::chrono::steady_clock::now();
  std::optional<CellReport> report;
  try {
    report = here();
  } catch (const std::exception& error) {
    report.emplace();
    report->outcome = Outcome::kCrash;
    report->message = error.what();
  }
  if (!report) return std::nullopt;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return record_of(cell, *report, seconds.count());
}

}  // namespace

bool CellSource::is_to_be_run(const PlanCell& cell) const {
  return journal == nullptr || journal->find(cell.key) == nullptr;
}

std::optional<Record> CellSource::record_of(
    const PlanCell& cell, const std::function<std::optional<CellReport>()>& here) const {
  if (journal != nullptr) {
    if (const Record* known = journal->find(cell.key)) return *known;
  }
  std::optional<Record> record = program.empty() ? run_here(cell, here) : run_in_child(cell, *this);
  if (!record || !go_on()) return std::nullopt;
  return journal == nullptr ? record : journal->add(*record);
}

}  // namespace kinex::sweep
