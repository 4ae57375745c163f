// SPDX-License-Identifier: GPL-3.0-or-later
// Question: does a run pay for what its scene requires, and for nothing else?
//   moving  k moving points among n resting ones: certificates with a polynomial, roots found and
//           memory beyond that of the resting points grow with k, not with n
//   shared  one, two, three attributes of one scene: the sum of their single costs, and less where
//           a structure is shared
//   padded  a scene of degree 1 written with coefficients 0 up to degree 3 runs as fast as without
//   unread  weights that no structure reads cost no time, and the memory of their axis
// Workload: uniform-square. Rounds are interleaved; the best of each counts; thread CPU time.
// Output: see result_table.h; options: see options.h.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/bench/options.h"
#include "experiments/bench/result_table.h"
#include "experiments/formats/weights.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace {

using namespace kinex;

Scene uniform_square(int n, int dimension, std::uint64_t seed) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.dimension = dimension;
  parameters.seed = seed;
  return lab::generate_scene(*lab::find_workload("uniform-square"), parameters);
}

struct Result {
  double setup = 0, seconds = 0;
  std::uint64_t events = 0;
  std::uint64_t polynomials = 0;  // failure times that took a polynomial, of any degree but 0
  std::uint64_t roots = 0;        // failure times found
  std::uint64_t bytes = 0;
};

Result run_once(const Scene& scene) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const double before = lab::cpu_seconds();
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  add_structures(simulator, scene);
  simulator.start();
  const double begin = lab::cpu_seconds();
  simulator.run_until(scene.end);
  Result result;
  result.setup = begin - before;
  result.seconds = lab::cpu_seconds() - begin;
  result.events = simulator.ledger().events;
  result.bytes = simulator.ledger().peak_bytes;
  const auto& solved = simulator.arithmetic().counters().polynomials_solved;
  for (std::size_t d = 1; d < solved.size(); ++d) result.polynomials += solved[d];
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    result.roots += simulator.ledger(id).failures_found;
  }
  return result;
}

// The best of several rounds, all scenes alternating.
std::vector<Result> run_all(const std::vector<Scene>& scenes, int rounds) {
  std::vector<Result> best(scenes.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const Result r = run_once(scenes[i]);
      if (round == 0 || r.seconds < best[i].seconds) best[i] = r;
    }
  }
  return best;
}

void ask_for(Scene& scene, const std::vector<const char*>& structures) {
  scene.maintain.clear();
  for (const char* name : structures) scene.maintain.push_back({name, name, {}});
}

// k points that move across the square, n that stand.
Scene few_moving(const char* structure, int k, int n) {
  const int dimension = std::strcmp(structure, "sorted_list") == 0 ? 1 : 2;
  Scene scene = uniform_square(n, dimension, 1);
  for (SceneObject& object : scene.objects) {
    for (auto& axis : object.motion.pieces[0].trajectory.coordinates) axis.resize(1);
  }
  // The same ones for every n. They are few, so that no two coincide.
  const Scene moving = uniform_square(k == 0 ? 1 : k, dimension, 2);
  for (int i = 0; i < k; ++i) {
    scene.objects[static_cast<std::size_t>(i)].motion =
        moving.objects[static_cast<std::size_t>(i)].motion;
  }
  ask_for(scene, {structure});
  return scene;
}

void moving(const BenchOptions& options) {
  const bool smoke = options.smoke;
  ResultTable table(options, "requires_moving", "moving: k points move among n that stand.",
                    {{"structure", ResultTable::kText, 12},
                     {"n", 0, 7},
                     {"k", 0, 5},
                     {"events", 0, 9},
                     {"polynomials", 0},
                     {"roots", 0, 10},
                     {"bytes", 0, 12},
                     {"seconds", 4}});
  for (const char* structure : {"sorted_list", "delaunay_2"}) {
    for (const int n : smoke ? std::vector<int>{100, 200} : std::vector<int>{2500, 10000, 40000}) {
      for (const int k : smoke ? std::vector<int>{0, 4} : std::vector<int>{0, 1, 10, 100}) {
        const Result r = run_all({few_moving(structure, k, n)}, smoke ? 1 : 3)[0];
        table.row({structure, n, k, r.events, r.polynomials, r.roots, r.bytes, r.seconds});
      }
    }
  }
}

void shared(const BenchOptions& options) {
  const bool smoke = options.smoke;
  const Scene square = uniform_square(smoke ? 30 : 2000, 2, 1);
  const std::vector<std::vector<const char*>> asked{
      {"sorted_list"},
      {"maximum_tournament"},
      {"delaunay_2"},
      {"sorted_list", "maximum_tournament"},
      {"sorted_list", "maximum_tournament", "delaunay_2"},
      {"maximum_sorted_list"},
      {"minimum_sorted_list"},
      {"sorted_list", "maximum_sorted_list", "minimum_sorted_list"},
  };
  std::vector<Scene> scenes(asked.size(), square);
  for (std::size_t i = 0; i < asked.size(); ++i) ask_for(scenes[i], asked[i]);
  const std::vector<Result> results = run_all(scenes, smoke ? 1 : 3);
  ResultTable table(options, "requires_shared",
                    "shared: attributes of one scene; the sum is of what each costs alone, n = " +
                        std::to_string(square.objects.size()) + ".",
                    {{"attributes", ResultTable::kText, 58},
                     {"events", 0, 9},
                     {"polynomials", 0, 12},
                     {"seconds", 4},
                     {"time_over_sum", 3}});
  for (std::size_t i = 0; i < asked.size(); ++i) {
    double sum = 0;
    std::string names;
    for (const char* name : asked[i]) {
      names += (names.empty() ? "" : ", ") + std::string(name);
      for (std::size_t j = 0; j < asked.size(); ++j) {
        if (asked[j].size() == 1 && std::strcmp(asked[j][0], name) == 0) sum += results[j].seconds;
      }
    }
    const Result& r = results[i];
    table.row({names, r.events, r.polynomials, r.seconds, r.seconds / sum});
  }
}

Scene padded_with_zeros(Scene scene) {
  for (SceneObject& object : scene.objects) {
    for (auto& axis : object.motion.pieces[0].trajectory.coordinates) axis.resize(4, Rational(0));
  }
  return scene;
}

void padded(const BenchOptions& options) {
  const bool smoke = options.smoke;
  ResultTable table(options, "requires_padded",
                    "padded: degree 1, written with coefficients 0 up to degree 3.",
                    {{"structure", ResultTable::kText, 12},
                     {"n", 0, 7},
                     {"seconds", 4},
                     {"padded_over_plain", 4}});
  for (const char* structure : {"sorted_list", "delaunay_2"}) {
    const bool list = std::strcmp(structure, "sorted_list") == 0;
    Scene scene = uniform_square(smoke ? 30 : 1500, list ? 1 : 2, 1);
    ask_for(scene, {structure});
    const std::vector<Result> results = run_all({scene, padded_with_zeros(scene)}, smoke ? 1 : 7);
    table.row({structure, scene.objects.size(), results[0].seconds,
               results[1].seconds / results[0].seconds});
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

void unread(const BenchOptions& options) {
  const bool smoke = options.smoke;
  ResultTable table(options, "requires_unread", "unread: weights that no structure reads.",
                    {{"structure", ResultTable::kText, 12},
                     {"n", 0, 7},
                     {"seconds", 4},
                     {"weighted_over_plain", 4},
                     {"more_bytes", 0}});
  for (const char* structure : {"sorted_list", "delaunay_2"}) {
    const bool list = std::strcmp(structure, "sorted_list") == 0;
    Scene scene = uniform_square(smoke ? 30 : 1500, list ? 1 : 2, 1);
    ask_for(scene, {structure});
    const std::vector<Result> results = run_all({scene, with_weights(scene)}, smoke ? 1 : 7);
    table.row({structure, scene.objects.size(), results[0].seconds,
               results[1].seconds / results[0].seconds, results[1].bytes - results[0].bytes});
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  moving(*options);
  shared(*options);
  padded(*options);
  unread(*options);
  return 0;
}
