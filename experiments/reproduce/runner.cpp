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

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct PointResult {
  lab::SeriesResult series;
  std::string trouble;
};

std::optional<PointResult> find_or_run(const lab::SeriesPoint& point, std::size_t place,
                                       sweep::Journal& journal, const RunnerOptions& options) {
  PointResult result;
  const sweep::Cell cell = planned(point);
  const sweep::Record* record = journal.find(cell.key);
  if (record == nullptr) {
    const auto begin = std::chrono::steady_clock::now();
    lab::SeriesOptions running;
    running.go_on = options.go_on;
    running.interrupt = options.interrupt;
    if (options.on_run) {
      running.on_run = [&](const std::string& what) { options.on_run(place, what); };
    }
    const std::optional<lab::SeriesResult> series = lab::run_point(point, running);
    if (!series) return std::nullopt;
    record = &journal.add(sweep::record_of(cell, report_of(*series), seconds_since(begin)));
  }
  result.series = series_of(*record, point, result.trouble);
  return result;
}

// nullopt: interrupted.
std::optional<lab::StudyResult> find_or_study(const lab::PaperPart& part, sweep::Journal& journal,
                                              const RunnerOptions& options, std::string& trouble) {
  const sweep::Cell cell = planned_study(part, options.quick);
  const sweep::Record* record = journal.find(cell.key);
  if (record == nullptr) {
    const auto begin = std::chrono::steady_clock::now();
    const lab::StudyResult result = part.study(options.quick, options.go_on);
    if (!options.go_on()) return std::nullopt;
    record = &journal.add(sweep::record_of(cell, report_of(result), seconds_since(begin)));
  }
  return study_of(*record, trouble);
}

lab::CheckedBy find_or_check(const lab::RunKey& run, sweep::Journal& journal,
                             const lab::SecondProgram& program, const RunnerOptions& options) {
  const sweep::Cell cell = planned_check(run, program.name());
  if (const sweep::Record* record = journal.find(cell.key)) return check_of(*record, run);
  if (options.on_check) options.on_check(run);
  const auto begin = std::chrono::steady_clock::now();
  lab::CheckedBy checked = program.check(run);
  // A refusal is not kept: the program, or the machine, may be mended.
  if (checked.outcome == lab::CheckedBy::Outcome::kFine && journal.runs()) {
    journal.add(sweep::record_of(cell, report_of(checked), seconds_since(begin)));
  }
  return checked;
}

}  // namespace

ReproducedPart run_part(const lab::PaperPart& part, sweep::Journal& journal,
                        const lab::SecondProgram& program, const RunnerOptions& options) {
  const std::vector<lab::SeriesPoint> points = part.points(options.quick);
  auto [found, interrupted] = lab::run_in_order<PointResult>(
      points.size(), options.jobs,
      [&](std::size_t i) { return find_or_run(points[i], i, journal, options); },
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
    if (const auto study = find_or_study(part, journal, options, trouble)) {
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
           [&](const lab::RunKey& run) { return find_or_check(run, journal, program, options); })) {
    done.troubles.push_back(std::move(refusal));
  }
  done.interrupted = done.interrupted || !options.go_on();
  return done;
}

}  // namespace kinex::reproduce
