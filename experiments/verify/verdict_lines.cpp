// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/verdict_lines.h"

#include <fmt/format.h>

#include <cstdint>
#include <numeric>

#include "experiments/formats/counted.h"
#include "experiments/lab/scene_command.h"

namespace kinex::verify {

std::array<std::size_t, 4> verdict_counts(const VerifyResult& result) {
  std::array<std::size_t, 4> counts{};
  for (const lab::CellResult& cell : result.cells)
    ++counts[static_cast<std::size_t>(cell.verdict())];
  for (const lab::GrowthResult& growth : result.growths) {
    ++counts[static_cast<std::size_t>(growth.check.verdict)];
  }
  for (const lab::StudyResult& study : result.studies) {
    ++counts[static_cast<std::size_t>(study.verdict())];
  }
  return counts;
}

std::string verdict_line(const VerifyResult& result, double seconds) {
  const std::array<std::size_t, 4> counts = verdict_counts(result);
  const auto count = [&](lab::Verdict verdict) {
    return counts[static_cast<std::size_t>(verdict)];
  };
  const std::size_t held = count(lab::Verdict::kConfirmed), failed = count(lab::Verdict::kRefuted);
  std::string text = fmt::format("{} of {} hold{}; {} fail{}", held,
                                 std::accumulate(counts.begin(), counts.end(), std::size_t{0}),
                                 held == 1 ? "s" : "", failed, failed == 1 ? "s" : "");
  if (count(lab::Verdict::kOpen) > 0)
    text += fmt::format("; {} inconclusive", count(lab::Verdict::kOpen));
  if (count(lab::Verdict::kGaveUp) > 0)
    text += fmt::format("; {} gave up", count(lab::Verdict::kGaveUp));
  if (result.interrupted) text += "; interrupted";
  return text + "; " + lab::duration_text(seconds);
}

std::string work_line(const VerifyResult& result) {
  std::size_t checks = result.growths.size(), runs = 0;
  std::uint64_t failures = 0;
  for (const lab::CellResult& cell : result.cells) {
    checks += cell.checks.size();
    runs += cell.trials.size();
    for (const lab::Trial& trial : cell.trials) failures += trial.measurement.run.events;
  }
  for (const lab::StudyResult& study : result.studies) checks += study.checks.size();
  std::string what = formats::counted(result.cells.size(), "cell", "cells");
  const std::string fits = formats::counted(result.growths.size(), "fit", "fits");
  what += result.studies.empty()
              ? " and " + fits
              : ", " + fits + " and " + formats::counted(result.studies.size(), "study", "studies");
  return fmt::format("{}: {}, {}, {}", what, formats::counted(checks, "check", "checks"),
                     formats::counted(runs, "run", "runs"),
                     formats::counted(failures, "certificate failure", "certificate failures"));
}

}  // namespace kinex::verify
