// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: what does collision detection cost: events per second in `exact` and in `double`; how
//   does the cost of an event, and of one certificate, grow with the vertices n and the separation
//   s; and how long do many bodies in a box take?
// Workloads: polygon-gears (both bodies turn, linear rotors), polygon-spin-orbit (rotors of degree
//   2), polygon-fan and polygons-in-box. Rounds of both arithmetics are interleaved; the best of
//   each counts; times are thread CPU time.
// Ratio: exact over double; 0 if double goes astray.
// Output: see result_table.h; options: see bench_options.h.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/lab/bench_aims.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/result_table.h"

namespace {

using namespace kinex;

double per_second(const lab::BenchRun& run) {
  return static_cast<double>(run.asked.processed) / std::max(run.seconds, 1e-9);
}

void add_row(const lab::BenchRow& row, const lab::BenchRun& exact, const lab::BenchRun& plain,
             lab::ResultTable& table) {
  const double events = static_cast<double>(std::max<std::uint64_t>(exact.asked.processed, 1));
  const double certificates =
      static_cast<double>(std::max<std::uint64_t>(exact.asked.certificates_created, 1));
  const StageCounts signs = exact.signs(), failures = exact.failures();
  const double asked = static_cast<double>(lab::total(signs) + lab::total(failures));
  const double fallen = asked - static_cast<double>(signs[0] + failures[0]);
  // A run with other events than the exact ones has no comparable time.
  const bool astray = plain.asked.corrupt ||
                      std::abs(static_cast<double>(plain.asked.processed) - events) > 0.02 * events;
  const std::optional<Rational>& separation = row.parameters.separation;
  table.row({row.structure, row.workload, row.parameters.n,
             separation ? (Rational(1) / *separation).to_double() : 0, exact.asked.processed,
             per_second(exact), 1e9 * exact.seconds / events, 1e9 * exact.seconds / certificates,
             certificates / events, asked / events, 100 * fallen / asked,
             astray ? 0 : exact.seconds / plain.seconds});
}

// The events of a sort and sweep of bounding boxes: the ends of all boxes in one list per axis.
std::uint64_t sweep_events(const Scene& bodies, const Rational& radius) {
  Scene ends;
  ends.name = "ends";
  ends.dimension = 2;
  ends.start = bodies.start;
  ends.end = bodies.end;
  for (const SceneObject& body : bodies.objects) {
    for (const int side : {-1, 1}) {
      SceneObject end{body.id + (side < 0 ? "-" : "+"), body.motion, {}};
      for (MotionPiece& piece : end.motion.pieces) {
        auto& axes = piece.trajectory.coordinates;
        axes.resize(2);
        for (auto& axis : axes) axis[0] += Rational(side) * radius;
      }
      ends.objects.push_back(std::move(end));
    }
  }
  std::uint64_t events = 0;
  for (const int axis : {0, 1}) {
    Request request{"sorted_list", "sorted_list", {}};
    request.key.axis = axis;
    ends.maintain = {request};
    events += lab::run_once(ends, {}).asked.processed;
  }
  return events;
}

// The longest times of 10,000 bodies: of those that start far apart and of those near each other.
struct Boxes {
  double sparse = 0, dense = 0;
};
Boxes measure_boxes(const lab::BenchOptions& options) {
  lab::ResultTable table(
      options, "collision_box",
      "separation_mixed on polygons-in-box: turning bodies of 8 vertices cross a box, in exact "
      "arithmetic; and what a sort and sweep of their boxes alone would cost in place of the grid "
      "(0: not counted, the square of n).",
      {{"bodies", 0, 7},
       {"radius", 4},
       {"area_percent", 1},
       {"events", 0, 9},
       {"contacts", 0, 9},
       {"grid_events", 0, 9},
       {"sweep_events", 0, 9},
       {"build_seconds", 2},
       {"seconds", 2},
       {"events_per_second", 0}});
  Boxes longest;
  for (const int inverse : {16, 4}) {
    const Rational radius(Integer(1), Integer(inverse));
    for (const int n : options.smoke ? std::vector<int>{8} : std::vector<int>{100, 1000, 10000}) {
      lab::BenchRow row = lab::speed_row("separation_mixed", "polygons-in-box", 1, n);
      row.parameters.m = 8;
      row.parameters.separation = Rational(Integer(3), Integer(4)) - Rational(2) * radius;
      const Scene scene = lab::scene_of(row);
      lab::BenchRun run = lab::run_once(scene, {});
      // Quadratic in n: not for the largest.
      const std::uint64_t sweep = n > 1000 ? 0 : sweep_events(scene, radius);
      const double r = radius.to_double();
      table.row({n, r, 100 * 2 * std::sqrt(2.0) * r * r, run.asked.processed,
                 run.asked.by_kind["contact"], run.asked.by_kind["grid"], sweep, run.build,
                 run.seconds, per_second(run)});
      (inverse == 4 ? longest.dense : longest.sparse) = run.build + run.seconds;
    }
  }
  return longest;
}

void collision(const lab::BenchOptions& options) {
  double best_rate = 0;
  {
    lab::ResultTable table(options, "collision",
                           "Two polygons, in exact arithmetic: time per event and per certificate; "
                           "questions that doubles could not answer; time over double (0: doubles "
                           "see other events, or do not finish).",
                           {{"structure", lab::ResultTable::kText, 22},
                            {"workload", lab::ResultTable::kText, 18},
                            {"n", 0, 4},
                            {"one_over_s", 0},
                            {"events", 0, 7},
                            {"events_per_second", 0},
                            {"ns_per_event", 0},
                            {"ns_per_certificate", 0},
                            {"certificates_per_event", 1},
                            {"questions_per_event", 1},
                            {"percent_fallen_through", 2},
                            {"time_over_double", 2}});
    for (const lab::BenchRow& row : lab::bench_rows("collision", options)) {
      const std::vector<lab::BenchRun> best =
          lab::best_runs(lab::scene_of(row), {{.arithmetic = "exact"}, {.arithmetic = "double"}},
                         {.count = row.rounds});
      add_row(row, best[0], best[1], table);
      if (row.workload != "polygon-gears" || row.structure != "separation_mixed") continue;
      best_rate = std::max(best_rate, per_second(best[0]));
    }
  }
  const Boxes boxes = measure_boxes(options);
  lab::report_aims(
      "collision_aims",
      {{"events per second of separation_mixed, linear rotors, best row", 200000, best_rate, false},
       {"seconds for 10,000 bodies that cover 1 % of a box", 60, boxes.sparse, true},
       {"seconds for 10,000 bodies that cover 18 % of a box", 60, boxes.dense, true}},
      options);
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, collision); }
