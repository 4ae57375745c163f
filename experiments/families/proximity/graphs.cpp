// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs whose edges have moving weights: points of one axis with ends.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

void add_edge(Scene& scene, int u, int v, std::vector<Rational> weight) {
  const std::string number = std::to_string(scene.objects.size());
  lab::add_object(scene, "e" + number, {std::move(weight)});
  scene.objects.back().ends = {"v" + std::to_string(u), "v" + std::to_string(v)};
}

// On a line between two random numbers of [0, 1] at t = 0 and at t = 1, multiples of 2^-20.
std::vector<Rational> random_weight(lab::WorkloadRandom& random) {
  const auto first = static_cast<std::int64_t>(random.below(lab::kGridUnits + 1));
  const auto last = static_cast<std::int64_t>(random.below(lab::kGridUnits + 1));
  return {lab::on_grid(first), lab::on_grid(last - first)};
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

// n edges of random weights between random vertices of m, 0 <= t <= 1. The first m - 1 edges are a random tree.
void generate_random_graph(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = Rational(1);
  for (int i = 0; i < parameters.n; ++i) {
    int u = 0, v = i + 1;
    if (v < parameters.m) {
      u = static_cast<int>(random.below(static_cast<std::uint64_t>(v)));
    } else {
      u = static_cast<int>(random.between(0, parameters.m - 1));
      v = static_cast<int>(random.between(1, parameters.m - 1) + u) % parameters.m;
    }
    add_edge(scene, u, v, random_weight(random));
  }
}

// The first n edges of random weights of a square grid with one diagonal in each square, row by row:
//
//      v0 -- v1 -- v2       the edges of a vertex to the left, upwards, and to the upper left;
//      |  \  |  \  |        about n/3 vertices; 0 <= t <= 1
//      v3 -- v4 -- v5
void generate_random_planar_graph(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = Rational(1);
  int side = 2;
  while (2 * side * (side - 1) + (side - 1) * (side - 1) < parameters.n) ++side;
  int edges = 0;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      for (const auto& [up, left] : {std::pair(0, 1), std::pair(1, 0), std::pair(1, 1)}) {
        if (row < up || column < left || edges == parameters.n) continue;
        add_edge(scene, (row - up) * side + column - left, row * side + column,
                 random_weight(random));
        ++edges;
      }
    }
  }
}

}  // namespace kinex::families
