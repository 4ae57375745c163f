// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/runner.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "experiments/formats/file_io.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/run_in_order.h"
#include "experiments/verify/planned.h"

namespace kinex::verify {

namespace {

// Writes the scene of trial k into the folder, under a descriptive name.
std::string keep_scene(const lab::Cell& cell, int k, const std::string& folder) {
  std::string name = "verify-failed-" + cell.structure + "-" + cell.workload_text() + "-n" +
                     std::to_string(cell.parameters.n) + "-seed" +
                     std::to_string(cell.parameters.seed + static_cast<std::uint64_t>(k)) + ".json";
  for (char& c : name) {
    if (c == ' ' || c == '/') c = '-';
  }
  formats::OutputFile file(folder + "/" + name, true);
  file.write(formats::write_scene(lab::scene_of(cell, k)));
  file.commit();
  return file.path();
}

lab::Trial run_trial(const lab::Cell& cell, int k, const VerifyOptions& options,
                std::optional<lab::SpeedContest>& contest) {
  const Scene scene = lab::scene_of(cell, k);
  SimulatorOptions simulator;
  simulator.audit = cell.audit;
  simulator.max_seconds = cell.max_seconds;
  simulator.progress = [&](const Simulator&) { return options.source.go_on(); };
  simulator.interrupt = options.interrupt;
  lab::Trial trial;
  trial.measurement = lab::measure(scene, "exact", simulator);
  trial.measurement.seed = cell.parameters.seed + static_cast<std::uint64_t>(k);
  trial.measurement.scene_hash = formats::scene_hash(scene);
  for (const lab::Expectation& expectation : cell.expectations) {
    const bool witness = expectation.kind == lab::ExpectationKind::kWitness;
    trial.witnessed.push_back(witness ? expectation.witness(scene) : Integer(0));
  }
  if (k == 0 && trial.measurement.status == RunStatus::kDone) {
    contest = lab::compare_with_double(scene, trial.measurement, simulator);
    if (contest) {
      contest->rival.seed = trial.measurement.seed;
      contest->rival.scene_hash = trial.measurement.scene_hash;
    }
  }
  return trial;
}

// Keeps the scene of every trial that a failed check names.
void keep_failures(lab::CellResult& result, const VerifyOptions& options) {
  std::set<std::size_t> kept;
  for (const lab::Check& check : result.checks) {
    if (check.verdict != lab::Verdict::kRefuted || !check.trial) continue;
    if (!kept.insert(*check.trial).second || options.keep_folder.empty()) continue;
    result.kept.push_back(
        keep_scene(result.cell, static_cast<int>(*check.trial), options.keep_folder));
  }
}

// The cell with the requested number of scenes.
lab::Cell with_seeds(lab::Cell cell, const VerifyOptions& options) {
  if (options.seeds && cell.random) cell.max_seeds = *options.seeds;
  return cell;
}

std::optional<lab::StudyResult> run_study(const lab::Study& study, const VerifyOptions& options) {
  const auto record = options.source.record_of(
      planned(study), [&]() -> std::optional<sweep::CellReport> {
        return report_of(study.run(study.quick, options.source.go_on));
      });
  if (!record) return std::nullopt;
  return study_of(*record, study);
}

}  // namespace

std::optional<lab::CellResult> run_trials(const lab::Cell& cell, const VerifyOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  lab::CellResult result;
  result.cell = with_seeds(cell, options);
  const int fewest = std::min(options.seeds && cell.random ? *options.seeds : cell.min_seeds,
                              result.cell.max_seeds);
  for (int k = 0; k < result.cell.max_seeds; ++k) {
    if (!options.source.go_on()) return std::nullopt;
    result.trials.push_back(run_trial(result.cell, k, options, result.contest));
    if (result.trials.back().measurement.status == RunStatus::kInterrupted) return std::nullopt;
    if (!options.source.go_on()) return std::nullopt;
    if (k + 1 >= fewest && precise_enough(cell, result.trials)) break;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  result.seconds = seconds.count();
  return result;
}

std::optional<lab::CellResult> run_cell(const lab::Cell& cell, const VerifyOptions& options) {
  const auto record = options.source.record_of(
      planned(cell, options.seeds), [&]() -> std::optional<sweep::CellReport> {
        const std::optional<lab::CellResult> result = run_trials(cell, options);
        if (!result) return std::nullopt;
        return report_of(*result);
      });
  if (!record) return std::nullopt;
  lab::CellResult result = result_of(*record, with_seeds(cell, options));
  if (!result.trials.empty()) result.checks = lab::judge(result.cell, result.trials);
  keep_failures(result, options);
  return result;
}

lab::Verdict VerifyResult::verdict() const {
  lab::Verdict worst = lab::Verdict::kConfirmed;
  for (const lab::CellResult& cell : cells) worst = std::max(worst, cell.verdict());
  for (const lab::GrowthResult& growth : growths) worst = std::max(worst, growth.check.verdict);
  for (const lab::StudyResult& study : studies) worst = std::max(worst, study.verdict());
  return worst;
}

VerifyResult run_catalogue(const lab::Catalogue& catalogue, const VerifyOptions& options) {
  const std::vector<lab::Cell>& cells = catalogue.cells;
  auto [finished, interrupted] = lab::run_in_order<lab::CellResult>(
      cells.size(), options.jobs,
      [&](std::size_t i) {
        if (options.on_start) options.on_start(i);
        return run_cell(cells[i], options);
      },
      options.on_cell);
  VerifyResult result;
  result.cells = std::move(finished);
  result.interrupted = interrupted;
  for (const lab::GrowthClaim& claim : catalogue.growths) {
    lab::GrowthResult growth = lab::judge_growth(claim, result.cells);
    if (!result.interrupted || growth.points.size() > 2) {
      result.growths.push_back(std::move(growth));
    }
  }
  for (const lab::Study& study : catalogue.studies) {
    if (result.interrupted) break;
    std::optional<lab::StudyResult> found = run_study(study, options);
    if (!found) break;
    result.studies.push_back(*std::move(found));
  }
  result.interrupted = result.interrupted || result.studies.size() < catalogue.studies.size();
  return result;
}

}  // namespace kinex::verify
