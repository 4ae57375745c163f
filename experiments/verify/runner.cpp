// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/runner.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "experiments/file_io.h"
#include "experiments/scene_writer.h"

namespace kinex {

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// The scene of trial k, in the folder for it, under a name that says what it is.
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
                std::optional<Contest>& contest) {
  const Scene scene = scene_of(cell, k);
  SimulatorOptions simulator;
  simulator.audit = cell.audit;
  simulator.max_seconds = cell.max_seconds;
  simulator.progress = [&](const Simulator&) { return options.go_on(); };
  Trial trial;
  trial.measurement = measure(scene, "exact", simulator);
  trial.measurement.seed = cell.parameters.seed + static_cast<std::uint64_t>(k);
  trial.measurement.scene_hash = scene_hash(scene);
  for (const Expectation& expectation : cell.expectations) {
    const bool witness = expectation.kind == ExpectationKind::kWitness;
    trial.witnessed.push_back(witness ? expectation.witness(scene) : Integer(0));
  }
  if (k == 0 && trial.measurement.status == RunStatus::kDone) {
    contest = compare_with_double(scene, trial.measurement, options.go_on);
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
    if (check.verdict != Verdict::kFail || !check.trial) continue;
    if (!kept.insert(*check.trial).second || options.keep_folder.empty()) continue;
    result.kept.push_back(
        keep_scene(result.cell, static_cast<int>(*check.trial), options.keep_folder));
  }
}

// Finished cells wait here until those before them are handed over.
class InOrder {
 public:
  InOrder(std::size_t cells, const VerifyOptions& options) : waiting_(cells), options_(options) {}

  void put(std::size_t index, CellResult result) {
    const std::lock_guard lock(mutex_);
    waiting_[index] = std::move(result);
    for (; next_ < waiting_.size() && waiting_[next_]; ++next_) hand_over(next_);
  }
  // Everything that is finished, cells after a gap too.
  std::vector<CellResult> take_all() {
    for (; next_ < waiting_.size(); ++next_) {
      if (waiting_[next_]) hand_over(next_);
    }
    return std::move(finished_);
  }

 private:
  void hand_over(std::size_t index) {
    if (options_.on_cell) options_.on_cell(index, *waiting_[index]);
    finished_.push_back(std::move(*waiting_[index]));
  }

  std::mutex mutex_;
  std::vector<std::optional<CellResult>> waiting_;
  std::size_t next_ = 0;
  std::vector<CellResult> finished_;
  const VerifyOptions& options_;
};

}  // namespace

std::optional<CellResult> run_cell(const Cell& cell, const VerifyOptions& options,
                                   const std::function<void(int seed)>& on_scene) {
  const auto begin = std::chrono::steady_clock::now();
  CellResult result;
  result.cell = cell;
  if (options.seeds && cell.random) result.cell.max_seeds = *options.seeds;
  const int fewest = std::min(options.seeds && cell.random ? *options.seeds : cell.min_seeds,
                              result.cell.max_seeds);
  for (int k = 0; k < result.cell.max_seeds; ++k) {
    if (!options.go_on()) return std::nullopt;
    if (on_scene) on_scene(k);
    try {
      result.trials.push_back(run_trial(result.cell, k, options, result.contest));
    } catch (const std::exception& error) {
      result.checks.push_back({"error", "run", "", "runs to the end", error.what(), "",
                               Verdict::kFail, static_cast<std::size_t>(k)});
      break;
    }
    if (result.trials.back().measurement.status == RunStatus::kInterrupted) return std::nullopt;
    if (!options.go_on()) return std::nullopt;
    if (k + 1 >= fewest && precise_enough(cell, result.trials)) break;
  }
  if (!result.trials.empty()) {
    std::vector<Check> checks = judge(result.cell, result.trials);
    checks.insert(checks.end(), result.checks.begin(), result.checks.end());
    result.checks = std::move(checks);
  }
  keep_failures(result, options);
  result.seconds = seconds_since(begin);
  return result;
}

Verdict VerifyResult::verdict() const {
  Verdict worst = Verdict::kPass;
  for (const CellResult& cell : cells) worst = std::max(worst, cell.verdict());
  for (const GrowthResult& growth : growths) worst = std::max(worst, growth.check.verdict);
  return worst;
}

VerifyResult run_catalogue(const Catalogue& catalogue, const VerifyOptions& options) {
  const std::vector<Cell>& cells = catalogue.cells;
  InOrder in_order(cells.size(), options);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> interrupted{false};
  std::exception_ptr trouble;  // not of a run: files that cannot be written
  std::mutex trouble_mutex;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < cells.size() && !interrupted; i = next++) {
        std::optional<CellResult> result = run_cell(cells[i], options, [&](int seed) {
          if (options.on_scene) options.on_scene(i, seed);
        });
        if (result) {
          in_order.put(i, *std::move(result));
        } else {
          interrupted = true;
        }
      }
    } catch (...) {
      const std::lock_guard lock(trouble_mutex);
      if (!trouble) trouble = std::current_exception();
      interrupted = true;
    }
  };
  std::vector<std::thread> threads;
  for (int k = 1; k < options.jobs; ++k) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (trouble) std::rethrow_exception(trouble);
  VerifyResult result;
  result.cells = in_order.take_all();
  result.interrupted = interrupted;
  for (const GrowthClaim& claim : catalogue.growths) {
    GrowthResult growth = judge_growth(claim, result.cells);
    if (!result.interrupted || growth.points.size() > 2) {
      result.growths.push_back(std::move(growth));
    }
  }
  return result;
}

}  // namespace kinex
