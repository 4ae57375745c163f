// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the benchmarks of this family; its own benchmark is in bench/.
#include <algorithm>

#include "experiments/families/collision/experiments.h"

namespace kinex::families {

namespace {

// A body of n vertices turns around one of n - 1 at a distance of 1 / `inverse`.
lab::BenchRow turning_row(std::string_view structure, std::string_view workload, int n, int inverse,
                          int turns) {
  lab::BenchRow row = lab::speed_row(structure, workload, 1, n);
  row.parameters.m = n - 1;
  row.parameters.separation = Rational(Integer(1), Integer(inverse));
  row.parameters.turns = turns;
  return row;
}

// bench/collision.cpp
std::vector<lab::BenchRow> collision_rows(int scale) {
  const int turns = std::max(100 / scale, 2), fewer = std::max(20 / scale, 2);
  const int n = lab::scaled_size(128, scale);
  std::vector<lab::BenchRow> rows;
  for (const int size : {8, 32, 128, 512}) {
    rows.push_back(turning_row("separation_mixed", "polygon-gears", lab::scaled_size(size, scale),
                               100, turns));
  }
  for (const int inverse : {1, 10, 1000, 10000}) {
    rows.push_back(turning_row("separation_mixed", "polygon-gears", n, inverse, turns));
  }
  rows.push_back(turning_row("separation_mixed", "polygon-spin-orbit", n, 100, turns));
  for (const char* other : {"separation_hysteresis", "closest_features", "inner_tangents"}) {
    rows.push_back(turning_row(other, "polygon-gears", n, 100, fewer));
  }
  rows.push_back(lab::speed_row("closest_features", "polygon-fan", 1, lab::scaled_size(64, scale)));
  for (lab::BenchRow& row : rows) row.benchmark = "collision";
  return rows;
}

}  // namespace

std::vector<lab::BenchRow> collision_bench_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  const int turns = std::max(100 / scale, 2), fewer = std::max(20 / scale, 2);
  std::vector<lab::BenchRow> rows = collision_rows(scale);
  for (const int size : {8, 32, n(128)}) {
    rows.push_back(turning_row("separation_mixed", "polygon-gears", size, 100, turns));
  }
  for (const char* other :
       {"separation_hysteresis", "closest_features", "inner_tangents", "bounding_volumes"}) {
    rows.push_back(turning_row(other, "polygon-gears", n(128), 100, fewer));
  }
  rows.push_back(turning_row("separation_mixed", "polygon-spin-orbit", n(128), 100, turns));
  rows.push_back(lab::speed_row("separation_minkowski", "polygon-orbit", 1, n(128)));
  rows.push_back(lab::speed_row("closest_features", "polygon-fan", 1, n(64)));
  rows.push_back(lab::speed_row("inner_tangents", "polygon-tangents", 1, n(64)));
  for (const int degree : {1, 2, 3}) {
    rows.push_back(lab::speed_row("separation_mixed", "polygon-random", degree, n(64)));
  }
  for (const int size : {10, n(100), n(1000)}) {
    rows.push_back(lab::speed_row("separation_mixed", "polygons-in-box", 1, size));
  }
  return rows;
}

}  // namespace kinex::families
