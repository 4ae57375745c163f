// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what do the slope certificates of the kinetic hull gain?
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 6: without
//   them a line can be the contender of Omega(n) vertices of the other chain.
// Scene: n points of a convex chain, one of which moves past, over n points in few lines, of which
//   all but two are covered.
// Expected: in the naive set, a point that is in at least n / 2 certificates; in the local one at
//   most 24 per half and level, for every n.
// Cost: seconds.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/engine/simulator.h"
#include "experiments/families/hull/experiments.h"
#include "experiments/lab/measurement.h"
#include "structures/hull/convex_hull_2.h"

namespace kinex::families {

namespace {

void add_point(Scene& scene, std::vector<Rational> x, std::vector<Rational> y) {
  Trajectory trajectory{{std::move(x), std::move(y)}};
  trajectory.normalise();
  Motion motion;
  motion.pieces.push_back({std::nullopt, std::nullopt, std::move(trajectory)});
  scene.objects.push_back({"p" + std::to_string(scene.objects.size()), std::move(motion)});
}

// A chain on the parabola, and far below it two points that cover the others.
Scene chain_over_a_line(int n, const char* structure) {
  const auto whole = [](std::int64_t k) { return Rational(Integer(k)); };
  Scene scene;
  scene.name = fmt::format("chain over a line, n={}", n);
  scene.dimension = 2;
  scene.start = 0;
  scene.end = 1;
  for (std::int64_t i = 0; i < n; ++i) {
    const std::int64_t x = 2 * i - n;
    add_point(scene, {whole(x), whole(1)}, {whole(-x * x)});
  }
  const std::int64_t low = -25 * std::int64_t{n} * n;
  for (std::int64_t i = 0; i < n; ++i) {
    if (i < 2) {
      add_point(scene, {whole((i == 0 ? -16 : 16) * std::int64_t{n} + i)}, {whole(low), whole(1)});
    } else {
      add_point(scene, {whole(i % 8)}, {whole(low - i), whole(-1)});
    }
  }
  scene.maintain = {{structure, structure, {}}};
  return scene;
}

}  // namespace

lab::StudyResult study_hull_locality(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "convex_hull_2";
  result.table.title = "convex_hull_2: the most certificates of one point, a chain over a line";
  result.table.header = {"n", "points", "naive", "local", "local per half and level"};
  for (const int n : {64, 256, 1024, 4096}) {
    if (quick && n > 1024) continue;
    if (!go_on()) return result;
    std::uint64_t most[2];
    for (const bool local : {false, true}) {
      SimulatorOptions options;
      options.audit = AuditLevel::kEnd;
      const lab::Measurement run = lab::measure(
          chain_over_a_line(n, local ? "convex_hull_2" : "convex_hull_2_naive"), "exact", options);
      most[local ? 1 : 0] = run.ledger.max_per_object;
      if (!run.clean()) {
        result.checks.push_back({"hull.locality.audit", "audit", "", "0 violations",
                                 run.violations.empty() ? "corrupt" : run.violations.front(), "",
                                 lab::Verdict::kRefuted, std::nullopt});
      }
    }
    const double levels = std::ceil(std::log2(2.0 * n));
    const double each = static_cast<double>(most[1]) / (2 * levels);
    result.table.rows.push_back({std::to_string(n), std::to_string(2 * n), std::to_string(most[0]),
                                 std::to_string(most[1]), fmt::format("{:.2f}", each)});
    result.checks.push_back(
        {fmt::format("hull.naive-locality.{}", n), "at least", "", fmt::format(">= {}", n / 2),
         std::to_string(most[0]), "Guibas 1998, section 6: not local without slope certificates",
         most[0] >= static_cast<std::uint64_t>(n) / 2 ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted,
         std::nullopt});
    result.checks.push_back(
        {fmt::format("hull.locality.{}", n), "bound", "",
         fmt::format("<= {} per half and level", ConvexHull2::kPerLevel),
         fmt::format("{:.2f}", each), "Guibas 1998, section 6: O(log n) certificates per point",
         each <= ConvexHull2::kPerLevel ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted, std::nullopt});
  }
  return result;
}

}  // namespace kinex::families
