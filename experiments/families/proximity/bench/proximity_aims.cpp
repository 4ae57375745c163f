// SPDX-License-Identifier: GPL-3.0-or-later
// Question: do the structures for near points, triangulations and arrangements reach the speed that they are
//   to have: time in `exact` over that in doubles, failures and external events per second, trees against
//   the triangulation that they read?
// Workload: the linear rows of `speed` of three families, without those full of ties or of new plans. Each
//   row is measured in a process of its own (own_process.h): in one for all, later rows may be
//   slower than the same rows alone. What is compared runs in pairs (compare): `exact` and doubles; a tree and
//   the triangulation that it reads.
// Times: thread CPU time of the run, structures that are read included. That of building them at the start
//   is a column of its own, and in no rate or ratio. Some rows stop after a number of failures: a column
//   says so.
// Ratio: the median over the pairs, of runs with the same failures and the same external events
//   (ChangesDigest) of all structures; else none, and a column says what doubles do. More than 5000 points are run
//   in `exact` alone. On a machine that others share the speed changes by more than half, for seconds at a
//   time: of the best runs of both one may have been slow throughout, of a pair hardly.
// Aims of ratios: of structures whose own certificates are of degree 2 or less (kHigherDegree), and of
//   triangulations in space. Scenes on which doubles report other changes are listed, too.
// Output: see result_table.h; options: see bench_options.h. A run in part (--rows) has no aims.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/lab/bench_aims.h"
#include "experiments/lab/bench_changes.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/family.h"
#include "experiments/lab/own_process.h"
#include "experiments/lab/result_table.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace {

using namespace kinex;

constexpr std::array<std::string_view, 3> kFamilies{"proximity", "triangulation", "arrangement"};
// Structures with certificates of their own of a degree above 2 in linear motion, and the degree. Others
// may read one of these.
const std::map<std::string_view, int> kHigherDegree{{"delaunay_2", 4},
                                                    {"delaunay_3", 5},
                                                    {"regular_2", 4},
                                                    {"regular_3", 5},
                                                    {"closest_pair_discs", 4},
                                                    {"closest_point_line", 6},
                                                    {"closest_point_line_vertical", 4}};
constexpr int kUsualDegree = 2;
constexpr std::array<std::string_view, 2> kInSpace{"delaunay_3",
                                                   "regular_3"};  // with an aim all the same
constexpr double kMostRatio = 1.3, kMostRatioInSpace = 1.5;
constexpr std::size_t kLeastPairs = 9, kMostPairs = 101;  // odd, as medians like them
constexpr double kPairedSeconds = 3;                      // enough, with kLeastPairs
// Of more points doubles may take hours: a structure that has lost its way makes all anew at every instant.
constexpr int kMostInDoubles = 5000;
constexpr std::string_view kSame = "report the same", kNotRun = "are not run";

struct Measured {
  std::string_view structure, scene;  // its workload
  int axes = 0, n = 0;
  bool whole = false;  // the run goes on to the end of the scene
  // The highest of certificates that were asked, those of structures that are read included.
  int degree = 0;
  // The best run in `exact`.
  std::uint64_t failures = 0, external = 0;
  double build = 0, seconds = 0;
  std::string_view doubles = kNotRun;  // what they do
  double ratio = 0;                    // over doubles that report the same; 0: they do not
};

// "-": there is none.
std::string ratio_text(double ratio) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f", ratio);
  return ratio == 0 ? "-" : text;
}

using Way = std::function<lab::BenchRun()>;

// The best runs of both, and the median of the ratios of the first one's time to that of the other in the
// same pair. Who goes first changes from pair to pair.
struct Pairs {
  lab::BenchRun first, other;
  double ratio = 0;
};

Pairs compare(const Way& first, const Way& other, bool smoke) {
  Pairs pairs;
  std::vector<double> ratios;
  double spent = 0;
  const auto is_enough = [&] {
    if (smoke) return !ratios.empty();
    if (ratios.size() < kLeastPairs || ratios.size() % 2 == 0) return false;
    return spent >= kPairedSeconds || ratios.size() >= kMostPairs;
  };
  while (!is_enough()) {
    const bool turned = ratios.size() % 2 == 1;
    lab::BenchRun later, one = turned ? other() : first();
    later = turned ? first() : other();
    if (turned) std::swap(one, later);
    spent += one.seconds + one.build + later.seconds + later.build;
    if (ratios.empty() || one.seconds < pairs.first.seconds) pairs.first = one;
    if (ratios.empty() || later.seconds < pairs.other.seconds) pairs.other = later;
    ratios.push_back(one.seconds / later.seconds);
  }
  std::ranges::sort(ratios);
  pairs.ratio = ratios[ratios.size() / 2];
  return pairs;
}

bool is_one_of(std::string_view name, const auto& names) {
  return std::ranges::find(names, name) != names.end();
}

double per_second(std::uint64_t count, const Measured& m) {
  return static_cast<double>(count) / m.seconds;
}

std::vector<lab::BenchRow> linear_rows(const lab::BenchOptions& options) {
  std::vector<lab::BenchRow> rows;
  for (lab::BenchRow& row : lab::bench_rows("speed", options)) {
    const lab::FamilyExperiments* const family = lab::experiments_on(row.structure);
    if (family == nullptr || !is_one_of(family->name, kFamilies) || row.parameters.degree != 1)
      continue;
    // Scenes full of ties and of new plans have rows of their own in `speed`.
    const lab::SceneKind kind = lab::find_workload(row.workload)->scenes;
    if (kind == lab::SceneKind::kTies || kind == lab::SceneKind::kNewPlans) continue;
    if (!is_one_of("double", row.arithmetics) || row.parameters.n >= 100'000) continue;
    rows.push_back(std::move(row));
  }
  return rows;
}

// A run that is not timed, and the digest of its changes.
struct Reported {
  lab::BenchRun run;
  std::uint64_t changes = 0;
  int degree = 0;
};

Reported reported_by(const Scene& scene, lab::BenchWay way) {
  Reported result;
  lab::ChangesDigest digest;
  way.prepare = [&digest](Simulator& simulator) { simulator.set_sink(&digest, false); };
  way.inspect = [&result](const Simulator& simulator) {
    const Arithmetic& numbers = simulator.arithmetic();
    for (PredicateId id = 0; id < numbers.predicates(); ++id) {
      if (lab::total(numbers.counters().by_predicate[id].failures) == 0) continue;
      result.degree = std::max(result.degree, numbers.predicate(id).degree(1));
    }
  };
  result.run = lab::run_once(scene, way);
  result.changes = digest.value();
  return result;
}

std::string_view verdict_on(const Reported& doubles, const Reported& exact, std::uint64_t most) {
  const bool corrupt = std::ranges::any_of(doubles.run.structures, &StructureLedger::corrupt);
  if (corrupt) return "become corrupt";
  if (doubles.run.events >= most && exact.run.events < most) return "do not end";
  const bool same = lab::same_events(doubles.run, exact.run) && doubles.changes == exact.changes;
  return same ? kSame : "handle other events";
}

// Throws std::runtime_error if a structure is missing in kHigherDegree.
void check_degree(const Measured& m, const Scene& scene) {
  int most = kUsualDegree;
  for (const PlannedStructure& planned : plan_structures(scene)) {
    const auto known = kHigherDegree.find(planned.request.structure);
    if (known != kHigherDegree.end()) most = std::max(most, known->second);
  }
  if (m.degree <= most) return;
  throw std::runtime_error("proximity_aims: certificates of " + std::string(m.structure) +
                           " have degree " + std::to_string(m.degree) + ", not " +
                           std::to_string(most) + ": add it to kHigherDegree");
}

Measured measure(const lab::BenchRow& row, const lab::BenchOptions& options) {
  const Scene scene = lab::scene_of(row);
  const Reported exact = reported_by(scene, {.arithmetic = "exact", .events = row.events});
  Measured m{row.structure, row.workload, scene.dimension, row.parameters.n};
  m.whole = row.events == 0 || exact.run.events < row.events;
  m.degree = exact.degree;
  check_degree(m, scene);
  // Doubles that cycle are stopped.
  const std::uint64_t most = row.events != 0 ? row.events : 4 * exact.run.events + 1000;
  if (row.parameters.n <= kMostInDoubles)
    m.doubles =
        verdict_on(reported_by(scene, {.arithmetic = "double", .events = most}), exact, most);
  const auto run_in = [&scene, most](const char* arithmetic) {
    return lab::run_once(scene, {.arithmetic = arithmetic, .events = most});
  };
  Pairs pairs;
  if (m.doubles == kSame) {
    pairs =
        compare([&] { return run_in("exact"); }, [&] { return run_in("double"); }, options.smoke);
    m.ratio = pairs.ratio;
  } else {
    const int rounds = options.smoke ? 1 : static_cast<int>(kLeastPairs);
    pairs.first = lab::best_of_rounds({[&] { return run_in("exact"); }}, {.count = rounds})[0];
  }
  m.failures = pairs.first.events;
  m.external = pairs.first.external();
  m.build = pairs.first.build;
  m.seconds = pairs.first.seconds;
  return m;
}

void add_row(const Measured& m, lab::ResultTable& table) {
  table.row({m.structure, m.scene, m.axes, m.n, m.whole ? "whole" : "stops early", m.degree,
             m.failures, m.external, m.build, m.seconds, per_second(m.failures, m),
             per_second(m.external, m), m.doubles, ratio_text(m.ratio)});
}

std::string place(const Measured& m) {
  const char* const axes = m.axes == 1 ? " on one axis" : m.axes == 3 ? " in space" : "";
  return std::string(m.scene) + axes + ", n = " + std::to_string(m.n);
}

// Both runs have the same flips; that of the tree has further events.
struct TreeTimes {
  double ratio = 0;
  std::uint64_t tree_failures = 0, read_failures = 0;
};

TreeTimes measure_trees(const lab::BenchRow& tree, const lab::BenchRow& read) {
  const Scene with_tree = lab::scene_of(tree), alone = lab::scene_of(read);
  const Pairs pairs = compare([&] { return lab::run_once(with_tree, {.arithmetic = "exact"}); },
                              [&] { return lab::run_once(alone, {.arithmetic = "exact"}); }, false);
  return {pairs.ratio, pairs.first.events, pairs.other.events};
}

const lab::BenchRow* whole_row(const std::vector<lab::BenchRow>& rows, std::string_view structure,
                               int n) {
  const auto row = std::ranges::find_if(rows, [&](const lab::BenchRow& one) {
    return one.structure == structure && one.workload == "uniform-square" &&
           one.parameters.n == n && one.events == 0;
  });
  return row == rows.end() ? nullptr : &*row;
}

void compare_trees(const std::vector<lab::BenchRow>& rows, std::string_view triangulation, int n,
                   std::vector<lab::Aim>& aims) {
  const lab::BenchRow* const tree = whole_row(rows, "emst_cycles", n);
  const lab::BenchRow* const read = whole_row(rows, triangulation, n);
  if (tree == nullptr || read == nullptr) return;
  const TreeTimes t = lab::in_own_process([&] { return measure_trees(*tree, *read); });
  const std::string both = " of emst_cycles over that of " + std::string(triangulation) +
                           ", in pairs, n = " + std::to_string(n);
  aims.push_back({"time" + both, 2, t.ratio, true});
  aims.push_back(
      {"time per failure" + both, 2,
       t.ratio * static_cast<double>(t.read_failures) / static_cast<double>(t.tree_failures),
       true});
}

// The worst row of each structure, of those that have a ratio.
std::map<std::string_view, const Measured*> worst_ratios(const std::vector<Measured>& rows) {
  std::map<std::string_view, const Measured*> worst;
  for (const Measured& m : rows) {
    if (m.ratio == 0) continue;
    const Measured*& known = worst[m.structure];
    if (known == nullptr || m.ratio > known->ratio) known = &m;
  }
  return worst;
}

bool has_aim(std::string_view structure) {
  return !kHigherDegree.contains(structure) || is_one_of(structure, kInSpace);
}

// One for each structure, and one for each scene on which doubles do not follow it.
void compare_with_doubles(const std::vector<Measured>& rows, std::vector<lab::Aim>& aims) {
  const std::map<std::string_view, const Measured*> worst = worst_ratios(rows);
  std::set<std::string_view> structures;
  for (const Measured& m : rows) {
    if (has_aim(m.structure)) structures.insert(m.structure);
  }
  for (const std::string_view structure : structures) {
    const double most = is_one_of(structure, kInSpace) ? kMostRatioInSpace : kMostRatio;
    const auto what = [](const Measured& m) {
      return "exact / double of " + std::string(m.structure) + ", " + place(m);
    };
    const auto known = worst.find(structure);
    if (known != worst.end()) {
      const Measured& m = *known->second;
      aims.push_back({what(m), most, m.ratio, true});
    }
    for (const Measured& m : rows) {
      if (m.structure != structure || m.ratio != 0) continue;
      if (m.doubles == kNotRun && known != worst.end()) continue;  // a larger size
      aims.push_back({what(m), most, 0, true, "doubles " + std::string(m.doubles)});
    }
  }
}

std::vector<lab::Aim> aims_of(const std::vector<Measured>& rows,
                              const std::vector<lab::BenchRow>& bench_rows) {
  std::vector<lab::Aim> aims;
  compare_with_doubles(rows, aims);
  for (const Measured& m : rows) {
    if (m.structure == "delaunay_3" && m.scene == "uniform-square") {
      aims.push_back({"failures per second of delaunay_3, n = " + std::to_string(m.n), 100'000,
                      per_second(m.failures, m), false});
    }
    if (m.structure == "closest_pair_local" && m.n == 10'000) {
      // The aim is of changes. Most failures are of the octants, and one reports several changes of theirs.
      char failures[64];
      std::snprintf(failures, sizeof failures, "%.0f", per_second(m.failures, m));
      aims.push_back(
          {"external events per second of closest_pair_local, n = 10000 (failures per "
           "second: " +
               std::string(failures) + ")",
           500'000, per_second(m.external, m), false});
    }
  }
  compare_trees(bench_rows, "delaunay_2", 1000, aims);
  compare_trees(bench_rows, "delaunay_3", 500, aims);
  return aims;
}

void report_unmeasured(const std::vector<lab::Aim>& aims, const lab::BenchOptions& options) {
  if (aims.empty()) return;
  lab::ResultTable table(options, "proximity_unmeasured",
                         "Aims for which nothing could be measured, and why.",
                         {{"aim", lab::ResultTable::kText, 62},
                          {"wanted", 2, 10},
                          {"reason", lab::ResultTable::kText, 27}});
  for (const lab::Aim& aim : aims) table.row({aim.what, aim.wanted, aim.unmeasured});
}

// Structures whose ratio has no aim, with the worst one.
void report_others(const std::vector<Measured>& rows, const lab::BenchOptions& options) {
  const std::map<std::string_view, const Measured*> worst = worst_ratios(rows);
  lab::ResultTable table(
      options, "proximity_without_aim",
      "No aim for exact / double: structures with certificates of their own of a "
      "degree above 2, but for delaunay_3 and regular_3, and the worst ratio measured (-: none "
      "could be).",
      {{"structure", lab::ResultTable::kText, 27},
       {"degree", 0},
       {"scene", lab::ResultTable::kText, 42},
       {"time_over_double", lab::ResultTable::kText, 4}});
  for (const auto& [structure, degree] : kHigherDegree) {
    if (has_aim(structure)) continue;
    const auto known = worst.find(structure);
    table.row({structure, degree, known == worst.end() ? "-" : place(*known->second),
               ratio_text(known == worst.end() ? 0 : known->second->ratio)});
  }
}

void proximity_aims(const lab::BenchOptions& options) {
  const std::vector<lab::BenchRow> bench_rows = linear_rows(options);
  std::vector<Measured> rows;
  {
    lab::ResultTable table(
        options, "proximity_speed",
        "Near points, triangulations, arrangements, in exact arithmetic, linear motion, structures "
        "that "
        "are read included. Seconds are those from the end of the construction (build seconds) to "
        "the end of the scene, or of the first failures where the run stops early; rates and "
        "ratios are of these seconds. Degree: the highest of a certificate of the run. Failures: "
        "of "
        "certificates. External events: changes of the attributes of all structures of the run, "
        "those "
        "that are read included. Time over double: - where doubles do not report the same changes "
        "or were not run.",
        {{"structure", lab::ResultTable::kText, 29},
         {"scene", lab::ResultTable::kText, 23},
         {"axes", 0},
         {"n", 0, 6},
         {"run", lab::ResultTable::kText, 11},
         {"degree", 0},
         {"failures", 0, 9},
         {"external_events", 0},
         {"build_seconds", 4},
         {"seconds", 4},
         {"failures_per_second", 0},
         {"external_events_per_second", 0},
         {"doubles", lab::ResultTable::kText, 19},
         {"time_over_double", lab::ResultTable::kText, 4}});
    for (const lab::BenchRow& row : bench_rows) {
      rows.push_back(lab::in_own_process([&] { return measure(row, options); }));
      add_row(rows.back(), table);
    }
  }
  if (options.smoke || !options.rows.empty()) return;
  std::vector<lab::Aim> aims = aims_of(rows, bench_rows);
  const auto unmeasured = std::stable_partition(
      aims.begin(), aims.end(), [](const lab::Aim& aim) { return aim.unmeasured.empty(); });
  lab::report_aims("proximity_aims", {aims.begin(), unmeasured}, options);
  report_unmeasured({unmeasured, aims.end()}, options);
  report_others(rows, options);
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, proximity_aims); }
