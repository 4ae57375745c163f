// SPDX-License-Identifier: GPL-3.0-or-later
// Question: does a run pay for what its scene requires, and for nothing else?
//   moving  k moving points among n resting ones: certificates with a polynomial, roots found and
//           memory beyond that of the resting points grow with k, not with n
//   shared  one, two, three attributes of one scene: the sum of their single costs, and less where
//           a structure is shared
//   padded  a scene of degree 1 written with coefficients 0 up to degree 3 runs as fast as without
//   unread  weights that no structure reads cost no time, and no memory beside that of the scene
// Workload: random motion. Rounds are interleaved; the best of each counts; thread CPU time.
// Output: see result_table.h; options: see bench_options.h.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "experiments/formats/weights.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/result_table.h"

namespace {

using namespace kinex;

// The best runs in `exact`.
std::vector<lab::BenchRun> run_all(const std::vector<Scene>& scenes, int rounds) {
  std::vector<std::function<lab::BenchRun()>> ways;
  for (const Scene& scene : scenes) {
    ways.emplace_back([&scene] { return lab::run_once(scene, {}); });
  }
  return lab::best_of_rounds(ways, {.count = rounds});
}

// Failure times that took a polynomial, of any degree but 0.
std::uint64_t polynomials_of(const lab::BenchRun& run) {
  std::uint64_t sum = 0;
  const auto& solved = run.numbers.polynomials_solved;
  for (std::size_t degree = 1; degree < solved.size(); ++degree) sum += solved[degree];
  return sum;
}

// Failure times found.
std::uint64_t roots_of(const lab::BenchRun& run) {
  std::uint64_t sum = 0;
  for (const StructureLedger& ledger : run.structures) sum += ledger.failures_found;
  return sum;
}

// k points that move across the square among the n of the row, which stand.
Scene few_moving(const lab::BenchRow& row, int k) {
  Scene scene = lab::scene_of(row);
  for (SceneObject& object : scene.objects) {
    for (auto& axis : object.motion.pieces[0].trajectory.coordinates) axis.resize(1);
  }
  // The same ones for every n. They are few, so that no two coincide.
  lab::BenchRow few = row;
  few.parameters.n = k == 0 ? 1 : k;
  few.parameters.seed = 2;
  const Scene moving = lab::scene_of(few);
  for (int i = 0; i < k; ++i) {
    scene.objects[static_cast<std::size_t>(i)].motion =
        moving.objects[static_cast<std::size_t>(i)].motion;
  }
  return scene;
}

void moving(const lab::BenchOptions& options) {
  lab::ResultTable table(options, "requires_moving", "moving: k points move among n that stand.",
                         {{"structure", lab::ResultTable::kText, 12},
                          {"n", 0, 7},
                          {"k", 0, 5},
                          {"events", 0, 9},
                          {"polynomials", 0},
                          {"roots", 0, 10},
                          {"bytes", 0, 12},
                          {"seconds", 4}});
  for (const lab::BenchRow& row : lab::bench_rows("requires_moving", options)) {
    for (const int k : options.smoke ? std::vector<int>{0, 4} : std::vector<int>{0, 1, 10, 100}) {
      const lab::BenchRun run = run_all({few_moving(row, k)}, row.rounds)[0];
      table.row({row.structure, row.parameters.n, k, run.events, polynomials_of(run), roots_of(run),
                 run.peak_bytes, run.seconds});
    }
  }
}

void shared(const lab::BenchOptions& options) {
  lab::BenchOptions all = options;
  all.rows.clear();
  const std::vector<lab::BenchRow> rows = lab::bench_rows("requires_shared", all);
  std::vector<Scene> scenes;
  for (const lab::BenchRow& row : rows) scenes.push_back(lab::scene_of(row));
  const std::vector<lab::BenchRun> runs = run_all(scenes, rows.front().rounds);
  lab::ResultTable table(
      options, "requires_shared",
      "shared: attributes of one scene; the sum is of what each costs alone, n = " +
          std::to_string(scenes.front().objects.size()) + ".",
      {{"attributes", lab::ResultTable::kText, 58},
       {"events", 0, 9},
       {"polynomials", 0, 12},
       {"seconds", 4},
       {"time_over_sum", 3}});
  const auto alone = [&](const std::string& structure) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::vector<Request>& maintain = rows[i].maintain;
      if (maintain.size() == 1 && maintain[0].structure == structure) return runs[i].seconds;
    }
    return 0.0;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double sum = 0;
    std::string names;
    for (const Request& request : rows[i].maintain) {
      names += (names.empty() ? "" : ", ") + request.structure;
      sum += alone(request.structure);
    }
    table.row(
        {names, runs[i].events, polynomials_of(runs[i]), runs[i].seconds, runs[i].seconds / sum});
  }
}

Scene padded_with_zeros(Scene scene) {
  for (SceneObject& object : scene.objects) {
    for (auto& axis : object.motion.pieces[0].trajectory.coordinates) axis.resize(4, Rational(0));
  }
  return scene;
}

void padded(const lab::BenchOptions& options) {
  lab::ResultTable table(options, "requires_padded",
                         "padded: degree 1, written with coefficients 0 up to degree 3.",
                         {{"structure", lab::ResultTable::kText, 12},
                          {"n", 0, 7},
                          {"seconds", 4},
                          {"padded_over_plain", 4}});
  for (const lab::BenchRow& row : lab::bench_rows("requires_padded", options)) {
    const Scene scene = lab::scene_of(row);
    const std::vector<lab::BenchRun> runs = run_all({scene, padded_with_zeros(scene)}, row.rounds);
    table.row(
        {row.structure, row.parameters.n, runs[0].seconds, runs[1].seconds / runs[0].seconds});
  }
}

Scene with_weights(Scene scene) {
  std::int64_t weight = 0;
  for (SceneObject& object : scene.objects) {
    formats::append_weight(object.motion, {Rational(++weight * 1000003)});
  }
  formats::complete_weights(scene);
  return scene;
}

void unread(const lab::BenchOptions& options) {
  lab::ResultTable table(options, "requires_unread", "unread: weights that no structure reads.",
                         {{"structure", lab::ResultTable::kText, 12},
                          {"n", 0, 7},
                          {"seconds", 4},
                          {"weighted_over_plain", 4},
                          {"more_bytes", 0}});
  for (const lab::BenchRow& row : lab::bench_rows("requires_unread", options)) {
    const Scene scene = lab::scene_of(row);
    const std::vector<lab::BenchRun> runs = run_all({scene, with_weights(scene)}, row.rounds);
    table.row({row.structure, row.parameters.n, runs[0].seconds, runs[1].seconds / runs[0].seconds,
               runs[1].peak_bytes - runs[0].peak_bytes});
  }
}

void requirements(const lab::BenchOptions& options) {
  moving(options);
  shared(options);
  padded(options);
  unread(options);
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, requirements); }
