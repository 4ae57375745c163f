// SPDX-License-Identifier: GPL-3.0-or-later
// Question: do the structures for near points, triangulations and arrangements reach the speed that they are
//   to have: time in `exact` over that in doubles, events and changes per second, trees against the
//   triangulation that they read?
// Workload: the linear rows of `speed` of three families. Rounds of both arithmetics are interleaved, and the best
//   of each counts: three or more, up to a second. Times are thread CPU time of the whole run, structures that
//   are read included.
// Ratio: 0 where doubles handle other events than `exact`, or do not end, and for more than 5000 points, which are
//   run in `exact` alone.
// Output: see result_table.h; options: see bench_options.h. A run in part (--rows) has no aims.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/lab/bench_aims.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/family.h"
#include "experiments/lab/result_table.h"

namespace {

using namespace kinex;

constexpr std::array<std::string_view, 3> kFamilies{"proximity", "triangulation", "arrangement"};
// Their certificates, of linear motion, are of a degree above 2; those of the others are not.
constexpr std::array<std::string_view, 5> kHigherDegree{"delaunay_2", "delaunay_3", "regular_2",
                                                        "regular_3", "closest_pair_discs"};
constexpr double kMostRatio = 1.3, kMostRatioInSpace = 1.5;
constexpr double kLeastSeconds = 1;
// Of more points doubles may take hours: a structure that has lost its way makes all anew at every instant.
constexpr int kMostInDoubles = 5000;

struct Measured {
  std::string_view structure;
  std::string scene;  // its workload, "uniform-square in space"
  int n = 0;
  lab::BenchRun exact;
  double ratio = 0;  // over doubles; 0: these handle other events
};

bool is_one_of(std::string_view name, const auto& names) {
  return std::ranges::find(names, name) != names.end();
}

// Changes that all structures of the run report, those that are read included.
double changes_per_second(const lab::BenchRun& run) {
  std::uint64_t changes = 0;
  for (const StructureLedger& ledger : run.structures) changes += ledger.processed;
  return static_cast<double>(changes) / run.seconds;
}

std::vector<lab::BenchRow> linear_rows(const lab::BenchOptions& options) {
  std::vector<lab::BenchRow> rows;
  for (lab::BenchRow& row : lab::bench_rows("speed", options)) {
    const lab::FamilyExperiments* const family = lab::experiments_on(row.structure);
    if (family == nullptr || !is_one_of(family->name, kFamilies) || row.parameters.degree != 1)
      continue;
    // Scenes full of ties and of new plans have rows of their own in `speed`.
    if (row.workload != "uniform-square" && !row.workload.starts_with("random-") &&
        row.workload != "apart-discs")
      continue;
    if (!is_one_of("double", row.arithmetics) || row.parameters.n >= 100'000) continue;
    rows.push_back(std::move(row));
  }
  return rows;
}

Measured measure(const lab::BenchRow& row, const lab::BenchOptions& options) {
  const Scene scene = lab::scene_of(row);
  const lab::BenchRun first = lab::run_once(scene, {.arithmetic = "exact", .events = row.events});
  // Doubles that cycle are stopped.
  const std::uint64_t most = row.events != 0 ? row.events : 4 * first.events + 1000;
  std::vector<lab::BenchWay> ways{{.arithmetic = "exact", .events = most}};
  if (row.parameters.n <= kMostInDoubles) ways.push_back({.arithmetic = "double", .events = most});
  const std::vector<lab::BenchRun> best = lab::best_runs(
      scene, ways, {.count = row.rounds, .least_seconds = options.smoke ? 0 : kLeastSeconds});
  const bool same = best.size() == 2 && lab::same_events(best[0], best[1]);
  // Rows without a dimension have as few axes as their structures allow.
  const bool in_space = row.parameters.dimension == 3;
  return {row.structure, std::string(row.workload) + (in_space ? " in space" : ""),
          row.parameters.n, best[0], same ? best[0].seconds / best[1].seconds : 0};
}

void add_row(const Measured& m, lab::ResultTable& table) {
  const double events = static_cast<double>(m.exact.events);
  table.row({m.structure, m.scene, m.n, m.exact.events, m.exact.seconds, events / m.exact.seconds,
             changes_per_second(m.exact), m.ratio});
}

std::string place(const Measured& m) { return m.scene + ", n = " + std::to_string(m.n); }

// Both runs have the same flips; that of the tree has further events.
void compare_trees(const std::vector<Measured>& rows, std::string_view triangulation, int n,
                   std::vector<lab::Aim>& aims) {
  const Measured *tree = nullptr, *read = nullptr;
  for (const Measured& m : rows) {
    if (m.n != n || !m.scene.starts_with("uniform-square")) continue;
    if (m.structure == "emst_cycles" && tree == nullptr) tree = &m;
    if (m.structure == triangulation && read == nullptr) read = &m;
  }
  if (tree == nullptr || read == nullptr) return;
  const auto per_event = [](const Measured& m) {
    return m.exact.seconds / static_cast<double>(m.exact.events);
  };
  const std::string both =
      " of emst_cycles over that of " + std::string(triangulation) + ", n = " + std::to_string(n);
  aims.push_back({"time" + both, 2, tree->exact.seconds / read->exact.seconds, true});
  aims.push_back({"time per event" + both, 2, per_event(*tree) / per_event(*read), true});
}

// The aims of the rows; the worst row of each structure counts for its ratio, of those that have one.
std::vector<lab::Aim> aims_of(const std::vector<Measured>& rows) {
  std::vector<lab::Aim> aims;
  std::map<std::string_view, const Measured*> worst;
  for (const Measured& m : rows) {
    if (m.ratio == 0) continue;
    const Measured*& known = worst[m.structure];
    if (known == nullptr || m.ratio > known->ratio) known = &m;
  }
  for (const auto& [structure, m] : worst) {
    const bool in_space = structure == "delaunay_3" || structure == "regular_3";
    if (is_one_of(structure, kHigherDegree) && !in_space) continue;
    const double most = in_space ? kMostRatioInSpace : kMostRatio;
    aims.push_back(
        {"exact / double of " + std::string(structure) + ", " + place(*m), most, m->ratio, true});
  }
  for (const Measured& m : rows) {
    if (m.structure == "delaunay_3" && m.scene.starts_with("uniform-square")) {
      aims.push_back({"events per second of delaunay_3, n = " + std::to_string(m.n), 100'000,
                      static_cast<double>(m.exact.events) / m.exact.seconds, false});
    }
    if (m.structure == "closest_pair_local" && m.n == 10'000) {
      aims.push_back({"changes per second of closest_pair_local, n = 10000", 500'000,
                      changes_per_second(m.exact), false});
    }
  }
  compare_trees(rows, "delaunay_2", 1000, aims);
  compare_trees(rows, "delaunay_3", 500, aims);
  return aims;
}

void proximity_aims(const lab::BenchOptions& options) {
  std::vector<Measured> rows;
  {
    lab::ResultTable table(
        options, "proximity_speed",
        "Near points, triangulations, arrangements, in exact arithmetic: whole runs of linear "
        "motion, what is read included; events are certificate failures, changes what structures "
        "report; time over double (0: doubles handle other events, or were not run).",
        {{"structure", lab::ResultTable::kText, 26},
         {"scene", lab::ResultTable::kText, 23},
         {"n", 0, 6},
         {"events", 0, 9},
         {"seconds", 4},
         {"events_per_second", 0},
         {"changes_per_second", 0},
         {"time_over_double", 2}});
    for (const lab::BenchRow& row : linear_rows(options)) {
      rows.push_back(measure(row, options));
      add_row(rows.back(), table);
    }
  }
  if (!options.smoke && options.rows.empty())
    lab::report_aims("proximity_aims", aims_of(rows), options);
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, proximity_aims); }
