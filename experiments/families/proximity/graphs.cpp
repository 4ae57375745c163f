// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs whose edges have moving weights: points of one axis with ends.
#include <string>

#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

void add_edge(Scene& scene, int u, int v, std::vector<Rational> weight) {
  const std::string number = std::to_string(scene.objects.size());
  lab::add_object(scene, "e" + number, {std::move(weight)});
  scene.objects.back().ends = {"v" + std::to_string(u), "v" + std::to_string(v)};
}

}  // namespace

// m bundles in a row, each of n parallel edges of weights i^2 - i t, i = 0 .. n - 1:
//
//      v0 === v1 === v2 === v3         m = 3; -1 <= t <= 2n
//
// The weights of a bundle are tangents of the parabola -t^2/4: each is the lightest in turn, and
// any two exchange their order, at t = i + j. So the tree changes m(n - 1) times.
void generate_parallel_edges(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = Rational(-1);
  scene.end = Rational(2 * parameters.n);
  for (int bundle = 0; bundle < parameters.m; ++bundle) {
    for (std::int64_t i = 0; i < parameters.n; ++i) {
      add_edge(scene, bundle, bundle + 1, {lab::fraction(i * i, 1), lab::fraction(-i, 1)});
    }
  }
}

// n edges between random vertices of m, with weights that are on a line between two random numbers
// of [0, 1] at t = 0 and at t = 1, multiples of 2^-20. The first m - 1 edges are a random tree.
void generate_random_graph(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = Rational(1);
  const auto weight = [&random] {
    const auto first = static_cast<std::int64_t>(random.below(lab::kGridUnits + 1));
    const auto last = static_cast<std::int64_t>(random.below(lab::kGridUnits + 1));
    return std::vector<Rational>{lab::on_grid(first), lab::on_grid(last - first)};
  };
  for (int i = 0; i < parameters.n; ++i) {
    int u = 0, v = i + 1;
    if (v < parameters.m) {
      u = static_cast<int>(random.below(static_cast<std::uint64_t>(v)));
    } else {
      u = static_cast<int>(random.between(0, parameters.m - 1));
      v = static_cast<int>(random.between(1, parameters.m - 1) + u) % parameters.m;
    }
    add_edge(scene, u, v, weight());
  }
}

}  // namespace kinex::families
