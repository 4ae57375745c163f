// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: how do the changes of triangulations in space, and of those of points with weights, grow on
//   random motion? Do they survive a hundred thousand events without a rebuild?
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 9, has n^(4/3) as a
//   preliminary figure for Delaunay triangulations in space, n^(3/2) for the plane, nothing on weights.
// Scenes: uniform-square and random-weights, a few seeds for each size.
// Expected: no rebuild and no violation of an audit, in any run; the powers as they are found.
// Cost: seconds; about a minute in full.
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/triangulation/experiments.h"
#include "experiments/lab/fit.h"
#include "experiments/lab/measurement.h"
#include "experiments/lab/statistics.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {
namespace {

struct Growth {
  const char* structure;
  const char* workload;
  int dimension;
  std::vector<int> sizes;  // ascending; the first half in quick runs
};

struct Size {
  int n = 0;
  lab::RunningMean changes, hidden;        // all; points that showed or hid
  std::uint64_t events = 0, rebuilds = 0;  // of all seeds
  std::string wrong;                       // empty: nothing
};

// Fewer seeds for larger sizes: about as many events.
int seeds_of(int n) { return n <= 64 ? 16 : n <= 256 ? 8 : 3; }

Size measured(const Growth& growth, int n) {
  Size size;
  size.n = n;
  for (int seed = 1; seed <= seeds_of(n); ++seed) {
    lab::WorkloadParameters parameters;
    parameters.n = n;
    parameters.dimension = growth.dimension;
    parameters.seed = static_cast<std::uint64_t>(seed);
    Scene scene = lab::generate_scene(growth.workload, parameters, growth.structure);
    scene.maintain = {{growth.structure, growth.structure, {}}};
    SimulatorOptions options;
    options.audit = AuditLevel::kEnd;
    const lab::Measurement run = lab::measure(scene, "exact", options);
    size.changes.add(static_cast<double>(run.ledger.external));
    const bool weighted = run.ledger.by_kind.contains("show");
    size.hidden.add(weighted ? static_cast<double>(run.ledger.by_kind.at("show") +
                                                   run.ledger.by_kind.at("hide"))
                             : 0);
    size.events += run.ledger.processed;
    size.rebuilds += run.ledger.rebuilds;
    if (!run.clean()) size.wrong = run.violations.empty() ? "corrupt" : run.violations.front();
  }
  return size;
}

std::string power_between(const Size& a, const Size& b) {
  return fmt::format("{:.3f}", std::log(b.changes.mean() / a.changes.mean()) /
                                   std::log(static_cast<double>(b.n) / a.n));
}

}  // namespace

lab::StudyResult study_triangulation_growth(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "triangulation_growth";
  result.table.title =
      "triangulations in space, and of points with weights: growth on random motion";
  result.table.header = {"structure",    "workload", "n",
                         "seeds",        "changes",  "power from the size before",
                         "show or hide", "events",   "rebuilds"};
  result.table.note =
      "changes, show or hide: means of a run. events, rebuilds: of all seeds. The last line of a "
      "structure "
      "is the power that fits all its sizes";
  const std::vector<Growth> all{
      {"delaunay_3", "uniform-square", 3, {16, 32, 64, 128, 256, 512, 1024}},
      {"regular_2", "random-weights", 2, {16, 32, 64, 128, 256, 512, 1024, 2048}},
      {"regular_3", "random-weights", 3, {16, 32, 64, 128, 256, 512, 1024}}};
  for (const Growth& growth : all) {
    std::vector<lab::FitPoint> points;
    std::vector<Size> sizes;
    std::uint64_t events = 0, rebuilds = 0;
    for (const int n : growth.sizes) {
      if (quick && n > 128) continue;
      if (!go_on()) return result;
      sizes.push_back(measured(growth, n));
      const Size& size = sizes.back();
      events += size.events;
      rebuilds += size.rebuilds;
      points.push_back(
          {static_cast<double>(n), size.changes.mean(), size.changes.standard_error()});
      result.table.rows.push_back(
          {growth.structure, growth.workload, std::to_string(n), std::to_string(seeds_of(n)),
           lab::mean_text(size.changes.mean(), size.changes.standard_error()),
           sizes.size() < 2 ? "" : power_between(sizes[sizes.size() - 2], size),
           lab::mean_text(size.hidden.mean(), size.hidden.standard_error()),
           std::to_string(size.events), std::to_string(size.rebuilds)});
      if (size.wrong.empty()) continue;
      result.checks.push_back({std::string(growth.structure) + ".growth.audit", "audit", "",
                               "0 violations", size.wrong, "", lab::Verdict::kRefuted,
                               std::nullopt});
    }
    if (const auto fit = lab::fit_power(points)) {
      result.table.rows.push_back({growth.structure, growth.workload, "", "", lab::fit_text(*fit),
                                   "", "", std::to_string(events), std::to_string(rebuilds)});
    }
    result.checks.push_back(
        {std::string(growth.structure) + ".growth.rebuilds", "bound", "",
         "0 rebuilds in random motion", fmt::format("{} in {} events", rebuilds, events),
         "points in general position",
         rebuilds == 0 ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted, std::nullopt});
  }
  return result;
}

}  // namespace kinex::families
