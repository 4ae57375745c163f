// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what does a hull to a proven error cost, and how large is its error?
// Source: structures/extent/directions_2.h: D^2 k^2 / (k^2 + 1) <= D'^2 <= D^2 for the diameter D of
//   all points and D' of the extreme points of 4k directions; at most 2kn events for linear motion.
// Scenes: random motion; a worst case of the hull; a worst case of the box.
// Expected: the error seen never exceeds the error proven, at any of the times that are looked at,
//   in exact rational arithmetic. Events and certificates as they are.
// Cost: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/extent/experiments.h"
#include "experiments/lab/measurement.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"
#include "structures/extent/extent_guarantees_audit.h"
#include "structures/plan.h"

namespace kinex::families {
namespace {

constexpr int kTimes = 24;

struct Method {
  const char* structure;
  int k;  // 0: exact
  const char* arithmetic;
};

Scene maintaining(Scene scene, const Method& method) {
  Request request{method.structure, method.structure, {}};
  if (method.k > 0) request.parameters = {{"k", Rational(method.k)}};
  scene.maintain = {std::move(request)};
  return scene;
}

// The least D'^2 / D^2 seen at kTimes times of a run.
Rational least_ratio(const Scene& scene, const Method& method) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, method.arithmetic, options);
  const StructureId id = asked_structure(scene);
  simulator->start();
  Rational least(1);
  for (int i = 1; i < kTimes; ++i) {
    const Rational t = scene.start + (*scene.end - scene.start) * Rational(i) / Rational(kTimes);
    simulator->run_until(t);
    if (simulator->ledger(id).corrupt) break;
    const Snapshot now = simulator->snapshot(t);
    const std::vector<ObjectId> vertices = simulator->structure(id).attribute().ids;
    const Rational all = squared_diameter(now, exact_hull(now, living(now)));
    if (!all.is_zero()) least = std::min(least, squared_diameter(now, vertices) / all);
  }
  return least;
}

std::string error_text(double square) { return fmt::format("{:.2e}", 1 - std::sqrt(square)); }

}  // namespace

lab::StudyResult study_directions(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "directions_2";
  result.table.title = "directions_2: a hull to a proven error against the exact one";
  result.table.header = {"scene", "structure", "k", "arithmetic", "events", "changes",
                         "certificates", "degree", "seconds", "error proven", "error seen"};
  result.table.note =
      "error: of the diameter, as a part of it; seen at 23 times of each run, in exact arithmetic. "
      "degree: of the certificates of linear motion";
  std::vector<Scene> scenes;
  lab::WorkloadParameters random{.n = quick ? 64 : 256, .seed = 7};
  scenes.push_back(lab::generate_scene("uniform-square", random, "directions_2"));
  lab::WorkloadParameters worst{.n = quick ? 12 : 24, .m = quick ? 12 : 24};
  scenes.push_back(lab::generate_scene("hull-worst", worst, "directions_2"));
  lab::WorkloadParameters box{.n = quick ? 32 : 64};
  scenes.push_back(lab::generate_scene("box-worst", box, "directions_2"));
  const std::vector<Method> methods{{"convex_hull_2", 0, "exact"}, {"directions_2", 2, "exact"},
                                    {"directions_2", 4, "exact"},  {"directions_2", 8, "exact"},
                                    {"directions_2", 16, "exact"}, {"directions_2", 8, "double"}};
  for (const Scene& base : scenes) {
    for (const Method& method : methods) {
      if (!go_on()) return result;
      const Scene scene = maintaining(base, method);
      SimulatorOptions options;
      options.audit = AuditLevel::kEnd;
      const lab::Measurement run = lab::measure(scene, method.arithmetic, options);
      const Rational seen = scene.end ? least_ratio(scene, method) : Rational(1);
      const Rational square(method.k * method.k);
      const Rational proven = method.k == 0 ? Rational(1) : square / (square + Rational(1));
      result.table.rows.push_back(
          {base.name, method.structure, method.k == 0 ? "" : std::to_string(method.k),
           method.arithmetic, std::to_string(run.ledger.failures),
           std::to_string(run.ledger.external), std::to_string(run.ledger.max_live),
           method.k == 0 ? "2" : "1", fmt::format("{:.3f}", run.seconds),
           method.k == 0 ? "0" : error_text(proven.to_double()),
           error_text(seen.to_double())});
      const bool exact = std::string(method.arithmetic) == "exact";
      if (exact && !run.clean()) {
        result.checks.push_back({"directions.audit", "audit", "", "0 violations",
                                 run.violations.empty() ? "corrupt" : run.violations.front(), "",
                                 lab::Verdict::kRefuted, std::nullopt});
      }
      if (method.k == 0 || !exact) continue;
      result.checks.push_back(
          {fmt::format("directions.error.{}.{}", base.name, method.k), "bound", "",
           "D'^2/D^2 >= " + proven.to_string(), fmt::format("{:.6f}", seen.to_double()),
           "the nearest of 4k directions is within atan(1/k)",
           seen < proven ? lab::Verdict::kRefuted : lab::Verdict::kConfirmed, std::nullopt});
    }
  }
  return result;
}

}  // namespace kinex::families
