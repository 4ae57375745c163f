// SPDX-License-Identifier: GPL-3.0-or-later
// Cells for tests of `kinex verify`: experiments whose outcome is known.
#ifndef KINEX_TESTS_EXPERIMENTS_VERIFY_CELLS_H
#define KINEX_TESTS_EXPERIMENTS_VERIFY_CELLS_H

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/order/inversions.h"
#include "experiments/verify/catalogue.h"
#include "experiments/verify/runner.h"

namespace kinex::test {

inline lab::Expectation expects(lab::ExpectationKind kind, const char* quantity) {
  lab::Expectation expectation;
  expectation.claim = "test.claim";
  expectation.kind = kind;
  expectation.quantity = quantity;
  expectation.source = "this test";
  return expectation;
}

// 28 swaps.
inline lab::Cell sorting_cell(int swaps) {
  lab::Cell cell;
  cell.question = "A test?";
  cell.structure = "sorted_list";
  cell.workload = "sort-worst";
  cell.parameters.n = 8;
  cell.family = "worst case";
  cell.expectations.push_back(expects(lab::ExpectationKind::kExact, "processed"));
  cell.expectations.back().exact = Integer(swaps);
  return cell;
}

inline lab::Cell random_cell(int n, int seeds) {
  lab::Cell cell;
  cell.question = "A test?";
  cell.structure = "sorted_list";
  cell.workload = "uniform-square";
  cell.parameters.n = n;
  cell.parameters.dimension = 1;
  cell.family = "uniform";
  cell.random = true;
  cell.min_seeds = cell.max_seeds = seeds;
  cell.expectations.push_back(expects(lab::ExpectationKind::kWitness, "processed"));
  cell.expectations.back().witness = families::inversions;
  return cell;
}

inline lab::CellResult run(const lab::Cell& cell, verify::VerifyOptions options = {}) {
  return verify::run_cell(cell, options).value();
}

// Four sizes n of three runs each, that count 10 n^exponent to 0.2 %.
inline std::vector<lab::CellResult> constructed_family(double exponent) {
  std::vector<lab::CellResult> cells;
  for (const int n : {100, 200, 400, 800}) {
    lab::CellResult cell;
    cell.cell.structure = "sorted_list";
    cell.cell.family = "constructed";
    cell.cell.min_seeds = cell.cell.max_seeds = 3;
    cell.cell.parameters.n = n;
    for (const int departure : {-1, 0, 1}) {
      lab::Trial trial;
      trial.measurement.objects = static_cast<std::size_t>(n);
      const double count = 10 * std::pow(n, exponent) * (1 + 0.002 * departure);
      trial.measurement.costs.processed = static_cast<std::uint64_t>(count);
      cell.trials.push_back(trial);
    }
    cells.push_back(cell);
  }
  return cells;
}

// Three sizes at random, and the one that is sorted.
inline lab::Catalogue small_catalogue() {
  lab::Catalogue catalogue;
  for (const int n : {8, 16, 32}) catalogue.cells.push_back(random_cell(n, 3));
  catalogue.cells.push_back(sorting_cell(28));
  catalogue.growths.push_back(
      {"test.growth", "sorted_list", "uniform", "processed", 1, 2, 10, "this test"});
  return catalogue;
}

}  // namespace kinex::test

#endif
