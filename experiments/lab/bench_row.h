// SPDX-License-Identifier: GPL-3.0-or-later
// BenchRow: a scene that a benchmark runs, and how. Families bring the rows; the benchmarks ask for
// theirs by name, and name neither structures nor workloads themselves.
#ifndef KINEX_EXPERIMENTS_LAB_BENCH_ROW_H
#define KINEX_EXPERIMENTS_LAB_BENCH_ROW_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/bench_options.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/workload.h"

namespace kinex::lab {

struct BenchRow {
  std::string_view benchmark;  // "speed"
  // What is maintained, unless `maintain` has other requests: it is then the name of them together,
  // or of the structure in question. Empty: what the workload's scenes maintain.
  std::string_view structure;
  std::string_view workload;
  // In a dimension of 0 the scene has as few axes as the structure and the workload allow, if that
  // is one axis, or three for a structure of space; otherwise as many as the workload's usual ones.
  WorkloadParameters parameters = {};
  std::vector<std::string_view> arithmetics = {"double", "exact"};  // ratios: over the first
  std::uint64_t events = 0;  // the run stops after so many; 0: at the end of the scene
  int rounds = 3;            // of which the best counts
  std::vector<Request> maintain = {};
  // The floor: the least program that handles the events of this structure, in plain doubles,
  // without error bounds, ties, ledger, proof and reports. It runs for `most` events, 0: to the end
  // of the scene. nullptr: there is none.
  BenchRun (*floor)(const Scene& scene, std::uint64_t most) = nullptr;

  // "structure scene degree n", by which --rows chooses.
  std::string text() const;
};

// A row of `speed`.
BenchRow speed_row(std::string_view structure, std::string_view workload, int degree, int n,
                   std::vector<std::string_view> arithmetics = {"double", "exact"});

// size / scale, but at least 8: the sizes of the test suite.
inline int scaled_size(int size, int scale) { return size / scale < 8 ? 8 : size / scale; }

// The rows of all families for a benchmark, without those that the options leave out.
std::vector<BenchRow> bench_rows(std::string_view benchmark, const BenchOptions& options);

// Throws std::invalid_argument for an unknown workload.
Scene scene_of(const BenchRow& row);

}  // namespace kinex::lab

#endif
