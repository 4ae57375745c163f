// SPDX-License-Identifier: GPL-3.0-or-later
// Question: does the kinetic hanger have as many events as its coins predict?
// Source: structures/maximum/maximum_hanger.h: the sum over all crossings of q(k), k the lines
//   above the crossing, O(n log n) for lines; da Fonseca, de Figueiredo, Carvalho, "Kinetic
//   hanger" (2004).
// Scenes: the worst cases of tournament and heap, and random motion; many seeds of the coins for
//   each, the first scene only.
// Expected: means within the standard errors that allowed_errors() gives for all rows together; and
//   expectations of the worst cases at most n log2 n.
// Cost: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/engine/simulator.h"
#include "experiments/families/maximum/experiments.h"
#include "experiments/lab/statistics.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload.h"
#include "structures/maximum/maximum_hanger.h"
#include "structures/plan.h"

namespace kinex::families {

namespace {

// q(k): the probability that two neighbours of the order with k objects above are parent and child.
std::vector<double> chances(std::size_t n) {
  std::vector<double> q{1.0};
  for (std::size_t k = 1; k < n; ++k) {
    double sum = 0, binomial = std::exp2(-static_cast<double>(k));  // C(k-1, j) / 2^k
    for (std::size_t j = 0; j < k; ++j) {
      sum += binomial * q[j];
      binomial = binomial * static_cast<double>(k - 1 - j) / static_cast<double>(j + 1);
    }
    q.push_back(sum);
  }
  return q;
}

struct Crossing {
  Rational time;
  std::size_t i, j;
};

// By a sweep over all crossings in time. Requires lines in one piece, no two crossing where others
// do.
double expectation_of(const Scene& scene) {
  const std::size_t n = scene.objects.size();
  const auto line = [&](std::size_t i) -> const Trajectory& {
    return scene.objects[i].motion.pieces[0].trajectory;
  };
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < n; ++i) {
    const Rational here = line(i).position(0, Rational(0)),
                   slope = line(i).position(0, Rational(1)) - here;
    for (std::size_t j = 0; j < i; ++j) {
      const Rational there = line(j).position(0, Rational(0));
      const Rational closing = line(j).position(0, Rational(1)) - there - slope;
      if (closing.is_zero()) continue;
      Rational time = (here - there) / closing;
      if (scene.start < time && (!scene.end || time <= *scene.end)) {
        crossings.push_back({std::move(time), i, j});
      }
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.time < b.time; });
  std::vector<std::size_t> order(n), place(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return line(b).position(0, scene.start) < line(a).position(0, scene.start);
  });
  for (std::size_t k = 0; k < n; ++k) place[order[k]] = k;
  const std::vector<double> q = chances(n);
  double sum = 0;
  for (const Crossing& crossing : crossings) {
    sum += q[std::min(place[crossing.i], place[crossing.j])];
    std::swap(place[crossing.i], place[crossing.j]);
  }
  return sum;
}

std::uint64_t events_of(const Scene& scene, std::uint64_t seed, lab::StudyResult& study) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  const StructureId id = simulator.reserve();
  simulator.add(id,
                std::make_unique<MaximumHanger>(simulator.kernel(), id, Key{}, scene,
                                                Extremum::kMaximum, seed),
                "maximum_hanger");
  simulator.start();
  simulator.run_until(std::nullopt);
  lab::check_run(simulator, scene.name, study);
  return simulator.ledger(id).processed;
}

struct Row {
  const char* workload;
  int n;
  bool worst;  // all lines are on the envelope, and all cross
  bool full_only;
};

constexpr Row kRows[] = {
    {"tournament-worst", 64, true, false}, {"tournament-worst", 256, true, true},
    {"heap-worst", 63, true, false},       {"heap-worst", 127, true, true},
    {"uniform-square", 64, false, false},  {"uniform-square", 256, false, false},
    {"uniform-square", 1024, false, true},
};

}  // namespace

lab::StudyResult study_hanger(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "maximum_hanger";
  result.table.title = "maximum_hanger: events over the seeds of its coins";
  result.table.header = {"workload",
                         "n",
                         "seeds",
                         "expected",
                         "events",
                         "standard errors apart",
                         "expected / (n log2 n)"};
  const int seeds = quick ? 100 : 400;
  int rows = 0;
  for (const Row& row : kRows) rows += !quick || !row.full_only ? 1 : 0;
  for (const Row& row : kRows) {
    if (quick && row.full_only) continue;
    lab::WorkloadParameters parameters;
    parameters.n = row.n;
    parameters.dimension = 1;
    const Scene scene = lab::generate_scene(*lab::find_workload(row.workload), parameters);
    const double expected = expectation_of(scene);
    lab::RunningMean mean;
    for (int seed = 1; seed <= seeds; ++seed) {
      if (!go_on()) return result;
      mean.add(static_cast<double>(events_of(scene, static_cast<std::uint64_t>(seed), result)));
    }
    const double apart = lab::distance_in_errors(mean.mean(), mean.standard_error(), expected, 0, 0);
    const double share = expected / (row.n * std::log2(row.n));
    result.table.rows.push_back({row.workload, std::to_string(row.n), std::to_string(seeds),
                                 fmt::format("{:.1f}", expected),
                                 lab::mean_text(mean.mean(), mean.standard_error()),
                                 fmt::format("{:.1f}", apart), fmt::format("{:.3f}", share)});
    const std::string scenes = fmt::format("{}.{}", row.workload, row.n);
    result.checks.push_back(
        {"hanger.expectation." + scenes, "mean", "processed", fmt::format("{:.1f}", expected),
         fmt::format("{} ({:.1f} se)", lab::mean_text(mean.mean(), mean.standard_error()), apart),
         "the sum of q(k) over all crossings with k lines above",
         apart > lab::allowed_errors(rows) ? lab::Verdict::kRefuted
         : quick                           ? lab::Verdict::kAgrees
                                           : lab::Verdict::kConfirmed,
         std::nullopt});
    if (!row.worst) continue;
    result.checks.push_back({"hanger.n-log-n." + scenes, "bound", "processed", "<= n log2 n",
                             fmt::format("{:.3f} n log2 n", share),
                             "da Fonseca, de Figueiredo, Carvalho 2004: O(n log n); the constant "
                             "is measured",
                             share <= 1 ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted, std::nullopt});
  }
  return result;
}

}  // namespace kinex::families
