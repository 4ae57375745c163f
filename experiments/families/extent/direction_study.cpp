// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what do a hull and a diameter to a proven error cost, and how large is their error?
// Source: structures/extent/directions_2.h: D^2 k^2 / (k^2 + 1) <= D'^2 <= D^2 for the diameter D of
//   all points and D' of the extreme points of 4k directions, or of the two that
//   diameter_directions names; at most 2kn changes of extreme points for linear motion.
// Scenes: random motion; a worst case of the hull; a worst case of the box.
// Expected: the error seen never exceeds the error proven, at any of the times that are looked at,
//   in exact rational arithmetic. Events and certificates as they are.
// Cost: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/extent/experiments.h"
#include "experiments/lab/curves.h"
#include "experiments/lab/measurement.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"
#include "experiments/lab/workload_parts.h"
#include "structures/extent/extent_guarantees_audit.h"
#include "structures/plan.h"

namespace kinex::families {
namespace {

constexpr int kTimes = 24;

// Times strictly inside of the scene's, ascending, at random: events of workloads are often at even
// parts of it. The same for all runs of a scene.
std::vector<Rational> times_of(const Scene& scene) {
  lab::WorkloadRandom random(1998);
  std::vector<std::int64_t> drawn;
  for (int i = 0; i < kTimes; ++i) drawn.push_back(random.between(1, lab::kGridUnits - 1));
  std::sort(drawn.begin(), drawn.end());
  std::vector<Rational> times;
  for (const std::int64_t units : drawn) {
    times.push_back(scene.start + (*scene.end - scene.start) * lab::on_grid(units));
  }
  return times;
}

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
  for (const Rational& t : times_of(scene)) {
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

// The least D'^2 / D^2 that is proven.
Rational proven_ratio(const Method& method) {
  const Rational square(method.k * method.k);
  return method.k == 0 ? Rational(1) : square / (square + Rational(1));
}

bool is_exact(const Method& method) { return std::string_view(method.arithmetic) == "exact"; }

struct Outcome {
  lab::Measurement run;
  Rational seen = Rational(1);
};

Outcome outcome_of(const Scene& base, const Method& method) {
  const Scene scene = maintaining(base, method);
  SimulatorOptions options;
  options.audit = AuditLevel::kEnd;
  Outcome outcome{lab::measure(scene, method.arithmetic, options), Rational(1)};
  if (scene.end) outcome.seen = least_ratio(scene, method);
  return outcome;
}

}  // namespace

lab::StudyResult study_directions(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "directions_2";
  result.table.title = "directions: a hull and a diameter to a proven error against the exact ones";
  result.table.header = {"scene",     "structure",    "k",      "arithmetic", "events",
                         "changes",   "certificates", "degree", "seconds",    "error proven",
                         "error seen"};
  result.table.note =
      "error: of the diameter, as a part of it; seen at 24 random times of each run, in exact "
      "arithmetic. "
      "degree: of the certificates of linear motion. events, changes, certificates: those of the "
      "structure itself, of diameter_2 without the hull that it reads; seconds: of the whole run";
  std::vector<Scene> scenes;
  lab::WorkloadParameters random{.n = quick ? 64 : 256, .seed = 7};
  scenes.push_back(lab::generate_scene("uniform-square", random, "directions_2"));
  lab::WorkloadParameters worst{.n = quick ? 12 : 24, .m = quick ? 12 : 24};
  scenes.push_back(lab::generate_scene("hull-worst", worst, "directions_2"));
  lab::WorkloadParameters box{.n = quick ? 32 : 64};
  scenes.push_back(lab::generate_scene("box-worst", box, "directions_2"));
  std::vector<Method> methods;
  for (const auto& [exact, directions] : {std::pair("convex_hull_2", "directions_2"),
                                          std::pair("diameter_2", "diameter_directions")}) {
    methods.push_back({exact, 0, "exact"});
    methods.push_back({exact, 0, "double"});
    for (const int k : {2, 4, 8, 16}) methods.push_back({directions, k, "exact"});
    methods.push_back({directions, 8, "double"});
  }
  for (const Scene& base : scenes) {
    for (const Method& method : methods) {
      if (!go_on()) return result;
      const auto [run, seen] = outcome_of(base, method);
      const Rational proven = proven_ratio(method);
      result.table.rows.push_back(
          {base.name, method.structure, method.k == 0 ? "" : std::to_string(method.k),
           method.arithmetic, std::to_string(run.ledger.failures),
           std::to_string(run.ledger.external), std::to_string(run.ledger.max_live),
           method.k == 0 ? "2" : "1", fmt::format("{:.3g}", run.seconds),
           method.k == 0 ? "0" : error_text(proven.to_double()), error_text(seen.to_double())});
      if (is_exact(method) && !run.clean()) {
        result.checks.push_back({"directions.audit", "audit", "", "0 violations",
                                 run.violations.empty() ? "corrupt" : run.violations.front(), "",
                                 lab::Verdict::kRefuted, std::nullopt});
      }
      if (method.k == 0 || !is_exact(method)) continue;
      result.checks.push_back(
          {fmt::format("{}.error.{}.{}", method.structure, base.name, method.k), "bound", "",
           "D'^2/D^2 >= " + proven.to_string(), fmt::format("{:.6f}", seen.to_double()),
           "the nearest of 4k directions is within atan(1/k)",
           seen < proven ? lab::Verdict::kRefuted : lab::Verdict::kConfirmed, std::nullopt});
    }
  }
  return result;
}

// Drawn from runs of its own: the cells have no exact structure beside them.
std::vector<lab::Figure> direction_figures(const std::vector<lab::CellResult>& cells) {
  const bool is_asked = std::any_of(cells.begin(), cells.end(), [](const lab::CellResult& result) {
    return result.cell.structure == "directions_2";
  });
  if (!is_asked) return {};
  lab::WorkloadParameters parameters{.n = 12, .m = 12};
  const Scene scene = lab::generate_scene("hull-worst", parameters, "directions_2");
  lab::Curve proven{"proven", {}, ""};
  proven.is_bound = true;
  std::vector<lab::Curve> errors, events;
  for (const auto& [name, exact, directions] :
       {std::tuple("hull", "convex_hull_2", "directions_2"),
        std::tuple("diameter", "diameter_2", "diameter_directions")}) {
    lab::Curve seen{std::string("seen: ") + name, {}, ""};
    lab::Curve by_k{std::string(name) + " by directions", {}, ""};
    lab::Curve without{std::string("exact ") + name, {}, ""};
    const auto exact_events =
        static_cast<double>(outcome_of(scene, {exact, 0, "exact"}).run.ledger.failures);
    for (const int k : {1, 2, 4, 8, 16, 32}) {
      const Method method{directions, k, "exact"};
      const auto [run, ratio] = outcome_of(scene, method);
      const auto x = static_cast<double>(k);
      const double error = 1 - std::sqrt(ratio.to_double());
      if (error > 0) seen.points.push_back({x, error, 0});
      by_k.points.push_back({x, static_cast<double>(run.ledger.failures), 0});
      without.points.push_back({x, exact_events, 0});
      if (errors.empty()) {
        proven.points.push_back({x, 1 - std::sqrt(proven_ratio(method).to_double()), 0});
      }
    }
    errors.push_back(std::move(seen));
    events.push_back(std::move(by_k));
    events.push_back(std::move(without));
  }
  errors.push_back(std::move(proven));
  lab::Figure error, event;
  error.title = kDirectionsTitle;
  error.caption =
      "Left: the error of the diameter, as a part of it, at the worst of 24 random times (none is drawn "
      "where it was 0), and the error proven. Right: certificate failures of the whole run, "
      "without those of the hull below the exact diameter. Scene: hull-worst, n = m = 12.";
  lab::set_curves(error, {.x = "k", .y = "error", .slopes = {}, .title = scene.name}, errors);
  event.title = error.title;
  event.joins = true;
  lab::set_curves(event, {.x = "k", .y = "certificate failures", .slopes = {}, .title = scene.name}, events);
  return {error, event};
}

}  // namespace kinex::families
