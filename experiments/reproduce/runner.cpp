// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproduce/runner.h"

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/lab/claim_check.h"
#include "experiments/lab/run_in_order.h"
#include "experiments/reproduce/planned.h"

namespace kinex::reproduce {

namespace {

struct PointResult {
  lab::SeriesResult series;
  std::string trouble;
};

// nullopt: interrupted.
std::optional<PointResult> run_point(const lab::SeriesPoint& point, std::size_t place,
                                     const RunnerOptions& options) {
  const sweep::PlanCell cell = planned(point);
  if (options.on_start && options.source.is_to_be_run(cell)) options.on_start(place, point);
  const auto record = options.source.record_of(cell, [&]() -> std::optional<sweep::CellReport> {
    lab::SeriesOptions running;
    running.go_on = options.source.go_on;
    running.interrupt = options.interrupt;
    const std::optional<lab::SeriesResult> series = lab::run_point(point, running);
    if (!series) return std::nullopt;
    return report_of(*series);
  });
  if (!record) return std::nullopt;
  PointResult result;
  result.series = series_of(*record, point, result.trouble);
  return result;
}

// nullopt: interrupted.
std::optional<lab::StudyResult> run_study(const lab::PaperPart& part, const RunnerOptions& options,
                                          std::string& trouble) {
  const auto record = options.source.record_of(
      planned_study(part, options.quick), [&]() -> std::optional<sweep::CellReport> {
        return report_of(part.study(options.quick, options.source.go_on));
      });
  if (!record) return std::nullopt;
  return study_of(*record, trouble);
}

// In this process: checks are of no plan.
lab::CheckedBy find_or_check(const lab::RunKey& run, const lab::SecondProgram& program,
                             const RunnerOptions& options) {
  sweep::Journal& journal = *options.source.journal;
  const sweep::PlanCell cell = planned_check(run, program.name());
  if (const sweep::Record* record = journal.find(cell.key)) return check_of(*record, run);
  if (options.on_check) options.on_check(run);
  const auto begin = std::chrono::steady_clock::now();
  lab::CheckedBy checked = program.check(run);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  // A refusal is not kept: the program, or the machine, may be mended.
  if (checked.finding == lab::CheckedBy::Finding::kFine && journal.runs()) {
    journal.add(sweep::record_of(cell, report_of(checked), seconds.count()));
  }
  return checked;
}

}  // namespace

ReproducedPart run_part(const lab::PaperPart& part, const lab::SecondProgram& program,
                        const RunnerOptions& options) {
  const std::vector<lab::SeriesPoint> points = part.points(options.quick);
  auto [found, interrupted] = lab::run_in_order<PointResult>(
      points.size(), options.jobs,
      [&](std::size_t i) { return run_point(points[i], i, options); },
      [&](std::size_t i, const PointResult&) {
        if (options.on_point) options.on_point(i);
      });
  ReproducedPart done;
  done.part = &part;
  done.interrupted = interrupted;
  std::vector<lab::SeriesResult> results;
  for (PointResult& one : found) {
    if (!one.trouble.empty()) done.troubles.push_back(std::move(one.trouble));
    for (const lab::RunRecord& run : one.series.runs) {
      if (!run.clean) done.troubles.push_back(run.key + ": " + run.trouble);
    }
    // A point without runs is as if it had been interrupted.
    if (one.series.runs.empty()) {
      done.interrupted = true;
    } else {
      results.push_back(std::move(one.series));
    }
  }
  if (part.study == nullptr) {
    done.report = part.report(results, options.command);
  } else {
    std::string trouble;
    if (const auto study = run_study(part, options, trouble)) {
      done.report = part.study_report(*study, options.command);
    } else {
      done.interrupted = true;
    }
    if (!trouble.empty()) done.troubles.push_back(std::move(trouble));
  }
  if (done.interrupted) {
    for (lab::PaperClaim& claim : done.report.claims) {
      claim.verdict = lab::Verdict::kOpen;
      claim.observed += "; interrupted: not all runs were made";
    }
  }
  for (std::string& refusal : lab::check_claims(
           done.report.claims, program.name(),
           [&](const lab::RunKey& run) { return find_or_check(run, program, options); })) {
    done.troubles.push_back(std::move(refusal));
  }
  for (lab::PaperClaim& claim : done.report.claims) {
    if (options.quick && claim.verdict == lab::Verdict::kConfirmed)
      claim.verdict = lab::Verdict::kAgrees;
  }
  done.interrupted = done.interrupted || !options.source.go_on();
  return done;
}

}  // namespace kinex::reproduce
