// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/runner.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <set>
#include <utility>

#include "experiments/formats/file_io.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/cell_record.h"
#include "experiments/lab/run_in_order.h"

namespace kinex {

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Writes the scene of trial k into the folder, under a descriptive name.
std::string keep_scene(const Cell& cell, int k, const std::string& folder) {
  std::string name = "verify-failed-" + cell.structure + "-" + cell.workload_text() + "-n" +
                     std::to_string(cell.parameters.n) + "-seed" +
                     std::to_string(cell.parameters.seed + static_cast<std::uint64_t>(k)) + ".json";
  for (char& c : name) {
    if (c == ' ' || c == '/') c = '-';
  }
  OutputFile file(folder + "/" + name, true);
  file.write(write_scene(scene_of(cell, k)));
  file.commit();
  return file.path();
}

Trial run_trial(const Cell& cell, int k, const VerifyOptions& options,
                std::optional<SpeedContest>& contest) {
  const Scene scene = scene_of(cell, k);
  SimulatorOptions simulator;
  simulator.audit = cell.audit;
  simulator.max_seconds = cell.max_seconds;
  simulator.progress = [&](const Simulator&) { return options.go_on(); };
  simulator.interrupt = options.interrupt;
  Trial trial;
  trial.measurement = measure(scene, "exact", simulator);
  trial.measurement.seed = cell.parameters.seed + static_cast<std::uint64_t>(k);
  trial.measurement.scene_hash = scene_hash(scene);
  for (const Expectation& expectation : cell.expectations) {
    const bool witness = expectation.kind == ExpectationKind::kWitness;
    trial.witnessed.push_back(witness ? expectation.witness(scene) : Integer(0));
  }
  if (k == 0 && trial.measurement.status == RunStatus::kDone) {
    contest = compare_with_double(scene, trial.measurement, simulator);
    if (contest) {
      contest->rival.seed = trial.measurement.seed;
      contest->rival.scene_hash = trial.measurement.scene_hash;
    }
  }
  return trial;
}

// Keeps the scene of every trial that a failed check names.
void keep_failures(CellResult& result, const VerifyOptions& options) {
  std::set<std::size_t> kept;
  for (const Check& check : result.checks) {
    if (check.verdict != Verdict::kRefuted || !check.trial) continue;
    if (!kept.insert(*check.trial).second || options.keep_folder.empty()) continue;
    result.kept.push_back(
        keep_scene(result.cell, static_cast<int>(*check.trial), options.keep_folder));
  }
}

void judge_runs(CellResult& result, const VerifyOptions& options) {
  if (!result.trials.empty()) {
    std::vector<Check> checks = judge(result.cell, result.trials);
    checks.insert(checks.end(), result.checks.begin(), result.checks.end());
    result.checks = std::move(checks);
  }
  keep_failures(result, options);
}

// The cell with the requested number of scenes.
Cell with_seeds(Cell cell, const VerifyOptions& options) {
  if (options.seeds && cell.random) cell.max_seeds = *options.seeds;
  return cell;
}

// As run_cell, except that finished work is not run again.
std::optional<CellResult> find_or_run(const Cell& cell, const VerifyOptions& options,
                                      const std::function<void(int seed)>& on_scene) {
  if (options.finished == nullptr) return run_cell(cell, options, on_scene);
  const std::string key = cell_key(cell, options.seeds);
  if (const std::optional<std::string> record = options.finished->find(key)) {
    std::optional<CellResult> result = read_cell_record(*record, with_seeds(cell, options));
    if (result) {
      judge_runs(*result, options);
      return result;
    }
  }
  std::optional<CellResult> result = run_cell(cell, options, on_scene);
  const bool threw = result && std::any_of(result->checks.begin(), result->checks.end(),
                                           [](const Check& c) { return c.claim == "error"; });
  if (result && !threw) options.finished->add(key, cell_record(*result));
  return result;
}

StudyResult find_or_run(const Study& study, const VerifyOptions& options) {
  if (options.finished != nullptr) {
    if (const std::optional<std::string> record = options.finished->find(study_key(study))) {
      if (std::optional<StudyResult> result = read_study_record(*record)) return *result;
    }
  }
  StudyResult result = study.run(study.quick, options.go_on);
  if (options.finished != nullptr && options.go_on()) {
    options.finished->add(study_key(study), study_record(result));
  }
  return result;
}

}  // namespace

std::optional<CellResult> run_cell(const Cell& cell, const VerifyOptions& options,
                                   const std::function<void(int seed)>& on_scene) {
  const auto begin = std::chrono::steady_clock::now();
  CellResult result;
  result.cell = with_seeds(cell, options);
  const int fewest = std::min(options.seeds && cell.random ? *options.seeds : cell.min_seeds,
                              result.cell.max_seeds);
  for (int k = 0; k < result.cell.max_seeds; ++k) {
    if (!options.go_on()) return std::nullopt;
    if (on_scene) on_scene(k);
    try {
      result.trials.push_back(run_trial(result.cell, k, options, result.contest));
    } catch (const std::exception& error) {
      if (!options.go_on()) return std::nullopt;
      result.checks.push_back({"error", "run", "", "runs to the end", error.what(), "",
                               Verdict::kRefuted, static_cast<std::size_t>(k)});
      break;
    }
    if (result.trials.back().measurement.status == RunStatus::kInterrupted) return std::nullopt;
    if (!options.go_on()) return std::nullopt;
    if (k + 1 >= fewest && precise_enough(cell, result.trials)) break;
  }
  judge_runs(result, options);
  result.seconds = seconds_since(begin);
  return result;
}

Verdict VerifyResult::verdict() const {
  Verdict worst = Verdict::kConfirmed;
  for (const CellResult& cell : cells) worst = std::max(worst, cell.verdict());
  for (const GrowthResult& growth : growths) worst = std::max(worst, growth.check.verdict);
  for (const StudyResult& study : studies) worst = std::max(worst, study.verdict());
  return worst;
}

VerifyResult run_catalogue(const Catalogue& catalogue, const VerifyOptions& options) {
  const std::vector<Cell>& cells = catalogue.cells;
  auto [finished, interrupted] = run_in_order<CellResult>(
      cells.size(), options.jobs,
      [&](std::size_t i) {
        return find_or_run(cells[i], options, [&](int seed) {
          if (options.on_scene) options.on_scene(i, seed);
        });
      },
      options.on_cell);
  VerifyResult result;
  result.cells = std::move(finished);
  result.interrupted = interrupted;
  for (const GrowthClaim& claim : catalogue.growths) {
    GrowthResult growth = judge_growth(claim, result.cells);
    if (!result.interrupted || growth.points.size() > 2) {
      result.growths.push_back(std::move(growth));
    }
  }
  for (const Study& study : catalogue.studies) {
    if (result.interrupted || !options.go_on()) break;
    StudyResult found = find_or_run(study, options);
    if (!options.go_on()) break;  // it may be a part of one
    result.studies.push_back(std::move(found));
  }
  result.interrupted = result.interrupted || result.studies.size() < catalogue.studies.size();
  return result;
}

}  // namespace kinex
