// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: what does collision detection cost: events per second in `exact` and in `double`; how
//   does the cost of an event, and of one certificate, grow with the vertices n and the separation
//   s; and how long do many bodies in a box take?
// Workloads: polygon-gears (both bodies turn, linear rotors), polygon-spin-orbit (rotors of degree
//   2), polygon-fan and polygons-in-box. Rounds of both arithmetics are interleaved; the best of
//   each counts; times are thread CPU time.
// Ratio: exact over double; 0 if double goes astray.
// Output: see result_table.h; options: see options.h.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/bench/options.h"
#include "experiments/bench/result_table.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace {

using namespace kinex;

struct Case {
  const char* structure;
  const char* workload;
  int n, m;
  int inverse_separation;  // s = 1 / this; 0: the family's own
  int turns;               // -1: the family takes none
  int rounds;
};

struct Result {
  std::uint64_t events = 0, certificates = 0, signs = 0, fallen = 0;
  double build = 0, run = 0;
  bool corrupt = false;
  std::map<std::string, std::uint64_t> by_kind;
};

Scene scene_of(const Case& one) {
  lab::WorkloadParameters parameters;
  parameters.n = one.n;
  parameters.m = one.m;
  parameters.turns = one.turns;
  if (one.inverse_separation > 0) {
    parameters.separation = Rational(Integer(1), Integer(one.inverse_separation));
  }
  Scene scene = lab::generate_scene(*lab::find_workload(one.workload), parameters);
  scene.maintain = {{one.structure, one.structure, {}}};
  return scene;
}

Result measure(const Scene& scene, const char* arithmetic) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  Simulator simulator(scene, planned_arithmetic(arithmetic, scene), options);
  add_structures(simulator, scene);
  Result result;
  const double start = lab::cpu_seconds();
  simulator.start();
  const double built = lab::cpu_seconds();
  simulator.run_until(std::nullopt);
  result.run = lab::cpu_seconds() - built;
  result.build = built - start;
  const StructureLedger& ledger = simulator.ledger(0);
  result.events = ledger.processed;
  result.certificates = ledger.certificates_created;
  result.corrupt = ledger.corrupt;
  result.by_kind = ledger.by_kind;
  for (const PredicateCounters& predicate :
       simulator.arithmetic().counters().by_predicate) {
    for (std::size_t stage = 0; stage < kStages; ++stage) {
      const std::uint64_t both = predicate.signs[stage] + predicate.failures[stage];
      result.signs += both;
      if (stage > 0) result.fallen += both;
    }
  }
  return result;
}

struct Pair {
  Result exact, plain;
};

Pair contest(const Case& one) {
  const Scene scene = scene_of(one);
  Pair best;
  for (int round = 0; round < one.rounds; ++round) {
    for (const bool exact : {true, false}) {
      const Result result = measure(scene, exact ? "exact" : "double");
      Result& kept = exact ? best.exact : best.plain;
      if (round == 0 || result.run < kept.run) kept = result;
    }
  }
  return best;
}

double per_second(const Result& result) {
  return static_cast<double>(result.events) / std::max(result.run, 1e-9);
}

void add_row(const Case& one, const Pair& pair, ResultTable& table) {
  const Result& exact = pair.exact;
  const double events = static_cast<double>(std::max<std::uint64_t>(exact.events, 1));
  const double certificates = static_cast<double>(std::max<std::uint64_t>(exact.certificates, 1));
  // A run with other events than the exact ones has no comparable time.
  const bool astray = pair.plain.corrupt ||
                      std::abs(static_cast<double>(pair.plain.events) - events) > 0.02 * events;
  table.row({one.structure, one.workload, one.n, one.inverse_separation, exact.events,
             per_second(exact), 1e9 * exact.run / events, 1e9 * exact.run / certificates,
             certificates / events, static_cast<double>(exact.signs) / events,
             100 * static_cast<double>(exact.fallen) / static_cast<double>(exact.signs),
             astray ? 0 : exact.run / pair.plain.run});
}

std::vector<Case> cases(bool smoke) {
  if (smoke) {
    return {{"separation_mixed", "polygon-gears", 8, 7, 10, 2, 1},
            {"closest_features", "polygon-fan", 4, 3, 0, -1, 1}};
  }
  std::vector<Case> list;
  for (const int n : {8, 32, 128, 512}) {
    list.push_back({"separation_mixed", "polygon-gears", n, n - 1, 100, 100, 3});
  }
  for (const int inverse : {1, 10, 100, 1000, 10000}) {
    if (inverse != 100)
      list.push_back({"separation_mixed", "polygon-gears", 128, 127, inverse, 100, 3});
  }
  list.push_back({"separation_mixed", "polygon-spin-orbit", 128, 127, 100, 100, 3});
  for (const char* other : {"separation_hysteresis", "closest_features", "inner_tangents"}) {
    list.push_back({other, "polygon-gears", 128, 127, 100, 20, 3});
  }
  list.push_back({"closest_features", "polygon-fan", 64, 64, 0, -1, 3});
  return list;
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
    events += measure(ends, "exact").events;
  }
  return events;
}

// The longest times of 10,000 bodies: of those that start far apart and of those near each other.
struct Boxes {
  double sparse = 0, dense = 0;
};
Boxes measure_boxes(const BenchOptions& options) {
  ResultTable table(
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
      lab::WorkloadParameters parameters;
      parameters.n = n;
      parameters.m = 8;
      parameters.separation = Rational(Integer(3), Integer(4)) - Rational(2) * radius;
      Scene scene = lab::generate_scene(*lab::find_workload("polygons-in-box"), parameters);
      scene.maintain = {{"separation_mixed", "separation_mixed", {}}};
      Result result = measure(scene, "exact");
      // Quadratic in n: not for the largest.
      const std::uint64_t sweep = n > 1000 ? 0 : sweep_events(scene, radius);
      const double r = radius.to_double();
      table.row({n, r, 100 * 2 * std::sqrt(2.0) * r * r, result.events, result.by_kind["contact"],
                 result.by_kind["grid"], sweep, result.build, result.run, per_second(result)});
      (inverse == 4 ? longest.dense : longest.sparse) = result.build + result.run;
    }
  }
  return longest;
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  double best_rate = 0;
  {
    ResultTable table(*options, "collision",
                      "Two polygons, in exact arithmetic: time per event and per certificate; "
                      "questions that doubles could not answer; time over double (0: doubles see "
                      "other events, or come to no end).",
                      {{"structure", ResultTable::kText, 22},
                       {"workload", ResultTable::kText, 18},
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
    for (const Case& one : cases(options->smoke)) {
      const Pair pair = contest(one);
      add_row(one, pair, table);
      if (std::string(one.workload) != "polygon-gears") continue;
      if (std::string(one.structure) != "separation_mixed") continue;
      best_rate = std::max(best_rate, per_second(pair.exact));
    }
  }
  const Boxes boxes = measure_boxes(*options);
  ResultTable aims(*options, "collision_aims", "Aims.",
                   {{"aim", ResultTable::kText, 62},
                    {"wanted", 2, 10},
                    {"measured", 2, 10},
                    {"met", ResultTable::kText, 4}});
  aims.row({"events per second of separation_mixed, linear rotors, best row", 200000, best_rate,
            best_rate >= 200000 ? "yes" : "no"});
  aims.row({"seconds for 10,000 bodies that cover 1 % of a box", 60, boxes.sparse,
            boxes.sparse < 60 ? "yes" : "no"});
  aims.row({"seconds for 10,000 bodies that cover 18 % of a box", 60, boxes.dense,
            boxes.dense < 60 ? "yes" : "no"});
  return 0;
}
