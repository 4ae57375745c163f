// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/runner.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <set>
#include <utility>

#include "experiments/formats/file_io.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/run_in_order.h"
#include "experiments/verify/planned.h"

namespace kinex::verify {

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

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
  simulator.progress = [&](const Simulator&) { return options.go_on(); };
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

void judge_runs(lab::CellResult& result, const VerifyOptions& options) {
  if (!result.trials.empty()) {
    std::vector<lab::Check> checks = lab::judge(result.cell, result.trials);
    checks.insert(checks.end(), result.checks.begin(), result.checks.end());
    result.checks = std::move(checks);
  }
  keep_failures(result, options);
}

// The cell with the requested number of scenes.
lab::Cell with_seeds(lab::Cell cell, const VerifyOptions& options) {
  if (options.seeds && cell.random) cell.max_seeds = *options.seeds;
  return cell;
}

// As run_cell, except that a cell of the journal is not run again.
std::optional<lab::CellResult> find_or_run(const lab::Cell& cell, const VerifyOptions& options,
                                           const std::function<void(int seed)>& on_scene) {
  if (options.journal == nullptr) return run_cell(cell, options, on_scene);
  const sweep::Cell key = planned(cell, options.seeds);
  if (const sweep::Record* record = options.journal->find(key.key)) {
    lab::CellResult result = result_of(*record, with_seeds(cell, options));
    judge_runs(result, options);
    return result;
  }
  std::optional<lab::CellResult> result = run_cell(cell, options, on_scene);
  const bool threw = result && std::any_of(result->checks.begin(), result->checks.end(),
                                           [](const lab::Check& c) { return c.claim == kThrew; });
  if (result && !threw) {
    options.journal->add(sweep::record_of(key, report_of(*result), result->seconds));
  }
  return result;
}

lab::StudyResult find_or_run(const lab::Study& study, const VerifyOptions& options) {
  const sweep::Cell key = planned(study);
  if (options.journal != nullptr) {
    if (const sweep::Record* record = options.journal->find(key.key)) {
      return study_of(*record, study);
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  lab::StudyResult result = study.run(study.quick, options.go_on);
  if (options.journal != nullptr && options.go_on()) {
    options.journal->add(sweep::record_of(key, report_of(result), seconds_since(begin)));
  }
  return result;
}

}  // namespace

std::optional<lab::CellResult> run_cell(const lab::Cell& cell, const VerifyOptions& options,
                                   const std::function<void(int seed)>& on_scene) {
  const auto begin = std::chrono::steady_clock::now();
  lab::CellResult result;
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
      result.checks.push_back({kThrew, "run", "", "runs to the end", error.what(), "",
                               lab::Verdict::kRefuted, static_cast<std::size_t>(k)});
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
        return find_or_run(cells[i], options, [&](int seed) {
          if (options.on_scene) options.on_scene(i, seed);
        });
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
    if (result.interrupted || !options.go_on()) break;
    lab::StudyResult found = find_or_run(study, options);
    if (!options.go_on()) break;  // it may be a part of one
    result.studies.push_back(std::move(found));
  }
  result.interrupted = result.interrupted || result.studies.size() < catalogue.studies.size();
  return result;
}

}  // namespace kinex::verify
