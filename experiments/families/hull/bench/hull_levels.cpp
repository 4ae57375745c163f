// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: in how many certificates is one point at most, on 16 workloads in the plane, against
//   log2 n (locality)? And at which heights of the tree do the events of random motion happen?
// Bound on locality: c per half and level, c = 24 (structures/hull/convex_hull_2.h); the column
//   `per_half_and_level` is the smallest sufficient c. Runs stop after 200,000 events, in
//   degenerate families after 20,000. In the families with changes, n changes happen.
// Second table: height 1 is above single points; `events_per_pair`: over the pairs of points that
//   meet at nodes of that height.
// Output: see result_table.h; options: see bench_options.h.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/result_table.h"
#include "experiments/lab/workload.h"
#include "structures/hull/convex_hull_2.h"

namespace {

using namespace kinex;

constexpr std::uint64_t kEvents = 200000, kDegenerateEvents = 20000;

struct Family {
  const char* workload;
  int degree;
  int largest;      // n
  bool degenerate;  // ties, or many events at one instant
};

// Workloads of dimension 2; in hull-worst, n counts both kinds of points.
constexpr Family kFamilies[] = {
    {"uniform-square", 1, 100000, false},   {"uniform-square", 2, 100000, false},
    {"uniform-square", 3, 100000, false},   {"uniform-disk", 1, 100000, false},
    {"gaussian", 1, 100000, false},         {"static-one-mover", 1, 100000, false},
    {"new-plans", 1, 100000, false},        {"come-and-go", 1, 100000, false},
    {"hull-worst", 1, 100000, false},       {"grid", 1, 100000, true},
    {"lattice", 1, 100000, true},           {"meet", 1, 100000, true},
    {"through-one-point", 1, 100000, true}, {"near-one-point", 1, 100000, true},
    {"collinear-instant", 1, 100000, true}, {"counter-rotating-rings", 1, 100000, true},
    {"expanding-circle", 1, 100000, true},  {"rotating-circle", 1, 100000, true}};

Scene scene_of(const Family& family, int n) {
  const lab::Workload& workload = *lab::find_workload(family.workload);
  lab::WorkloadParameters parameters;
  const bool two_kinds = workload.takes_m && !workload.random;
  parameters.n = two_kinds ? n / 2 : n;
  parameters.seed = 1;
  parameters.degree = family.degree;
  parameters.dimension = 2;
  Scene scene = lab::generate_scene(workload, parameters);
  scene.maintain = {{"convex_hull_2", "convex_hull_2", {}}};
  return scene;
}

int levels_of(std::size_t n) {
  int levels = 0;
  for (std::size_t k = 1; k < n; k *= 2) ++levels;
  return levels;
}

double measure_locality(const std::vector<int>& sizes, lab::ResultTable& table) {
  double worst = 0;
  for (const Family& family : kFamilies) {
    for (const int n : sizes) {
      if (n > family.largest) continue;
      const Scene scene = scene_of(family, n);
      const lab::BenchRun run =
          lab::run_once(scene, {.events = family.degenerate ? kDegenerateEvents : kEvents});
      const int levels = levels_of(scene.objects.size());
      const double most = static_cast<double>(run.asked.max_per_object);
      worst = std::max(worst, most / (2 * levels));
      table.row({family.workload, family.degree, n, run.asked.processed, levels,
                 std::uint64_t{run.asked.max_per_object}, most / (2 * levels),
                 run.build + run.seconds});
    }
  }
  return worst;
}

// n: a power of two.
void measure_levels(int n, lab::ResultTable& table) {
  std::vector<std::uint64_t> events;
  lab::BenchWay way;
  way.inspect = [&](const Simulator& simulator) {
    events = dynamic_cast<const ConvexHull2&>(simulator.structure(0)).failures_by_level();
  };
  const lab::BenchRun run = lab::run_once(scene_of(kFamilies[0], n), way);
  const double all = static_cast<double>(run.asked.processed);
  for (std::size_t height = 1; height < events.size(); ++height) {
    const double k = static_cast<double>(events[height]);
    // n / 2^h nodes over 2^(h-1) red and as many blue points.
    const double pairs = n * std::ldexp(0.25, static_cast<int>(height));
    table.row({kFamilies[0].workload, n, static_cast<int>(height), events[height], 100 * k / all,
               k / pairs});
  }
}

void hull_levels(const lab::BenchOptions& options) {
  double worst = 0;
  {
    lab::ResultTable table(options, "hull_locality",
                           "The most certificates of one point in convex_hull_2, in exact "
                           "arithmetic.",
                           {{"workload", lab::ResultTable::kText, 22},
                            {"degree", 0},
                            {"n", 0, 7},
                            {"events", 0, 8},
                            {"levels", 0},
                            {"most_per_point", 0},
                            {"per_half_and_level", 2},
                            {"seconds", 2, 7}});
    worst = measure_locality(
        options.smoke ? std::vector<int>{30} : std::vector<int>{1000, 10000, 100000}, table);
  }
  {
    lab::ResultTable table(options, "hull_locality_bound",
                           "The largest of all, beside the bound that is proved, per half and "
                           "level.",
                           {{"seen", 2}, {"bound", 0}});
    table.row({worst, ConvexHull2::kPerLevel});
  }
  lab::ResultTable table(options, "hull_levels",
                         "Events of convex_hull_2 by the height of their node.",
                         {{"workload", lab::ResultTable::kText, 15},
                          {"n", 0, 7},
                          {"height", 0},
                          {"events", 0, 8},
                          {"percent", 1},
                          {"events_per_pair", 6}});
  for (const int n : options.smoke ? std::vector<int>{64} : std::vector<int>{1024, 16384, 131072}) {
    measure_levels(n, table);
  }
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, hull_levels); }
