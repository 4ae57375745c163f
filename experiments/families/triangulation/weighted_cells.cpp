// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: does the regular triangulation change exactly as often as counted by another program? Do
//   hidden points show and hide as often as constructed? How many events does random motion cause?
// Sources: flips of small integers counted by brute force over exact positions between all critical
//   times; the arguments in weighted_points.cpp; means of random weights from a simulation that makes no
//   triangulation (reference_means.h).
// Expected: the integers below, in every run; every hard bound, and every audit. No exponent: n is small.
// Cost: about half a minute, some minutes in full.
#include <cstdint>
#include <string>
#include <utility>

#include "experiments/families/points/random_motion.h"
#include "experiments/families/points/reference_means.h"
#include "experiments/families/triangulation/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {
namespace {

// Of means that are compared with those of another program.
constexpr double kMeanError = 0.02;

void add_small_weights(lab::Catalogue& catalogue) {
  struct Counted {
    const char* workload;
    int n;
    std::uint64_t seed;
    int flips, hull_flips, show, hide;
  };
  for (const Counted& one : {Counted{"small-weights", 8, 1, 8, 6, 4, 3},
                             {"small-weights", 10, 2, 18, 10, 4, 3},
                             {"small-moving-weights", 8, 1, 9, 7, 4, 4},
                             {"small-moving-weights", 10, 2, 27, 18, 4, 4}}) {
    lab::Cell cell = lab::worst_case_cell("regular_2", one.workload, one.n, 1, 0.1);
    cell.parameters.seed = one.seed;
    cell.audit = AuditLevel::kEvents;
    const auto expect = [&cell](const char* claim, const char* quantity, int count) {
      cell.expectations.push_back(lab::expect_exactly(
          claim, quantity, Integer(count), "counted by brute force over exact positions"));
    };
    expect("regular_2.small_weights.flips", "kind.flip", one.flips);
    expect("regular_2.small_weights.hull", "kind.enter+kind.leave", one.hull_flips);
    expect("regular_2.small_weights.show", "kind.show", one.show);
    expect("regular_2.small_weights.hide", "kind.hide", one.hide);
    catalogue.cells.push_back(std::move(cell));
  }
}

void add_small_weights_in_space(lab::Catalogue& catalogue) {
  struct Counted {
    int n;
    std::uint64_t seed;
    int inner_2_3, hull_2_3, inner_3_2, hull_3_2, show, hide;
  };
  for (const Counted& one : {Counted{6, 1, 2, 1, 1, 2, 1, 1}, {7, 2, 2, 2, 2, 3, 0, 0}}) {
    lab::Cell cell = lab::worst_case_cell("regular_3", "small-moving-weights", one.n, 1, 0.1);
    cell.parameters.seed = one.seed;
    cell.parameters.dimension = 3;
    cell.audit = AuditLevel::kEvents;
    const auto expect = [&cell](const char* claim, const char* quantity, int count) {
      cell.expectations.push_back(lab::expect_exactly(
          claim, quantity, Integer(count), "counted by brute force over exact positions"));
    };
    expect("regular_3.small_weights.2_3", "kind.flip_2_3", one.inner_2_3);
    expect("regular_3.small_weights.3_2", "kind.flip_3_2", one.inner_3_2);
    expect("regular_3.small_weights.hull_2_3", "kind.enter+kind.hull_2_3", one.hull_2_3);
    expect("regular_3.small_weights.hull_3_2", "kind.leave+kind.hull_3_2", one.hull_3_2);
    expect("regular_3.small_weights.show", "kind.show", one.show);
    expect("regular_3.small_weights.hide", "kind.hide", one.hide);
    catalogue.cells.push_back(std::move(cell));
  }
}

void add_random(lab::Catalogue& catalogue, const char* structure, int dimension, int n) {
  lab::Cell cell = uniform_cell(structure, n, dimension);
  cell.cost = dimension == 2 ? n / 100.0 : n / 40.0;
  catalogue.cells.push_back(cell);
  cell.workload = cell.family = "random-weights";
  const ReferenceMean reference = reference_mean(structure, n);
  cell.precise = {{"external", reference.seeds > 0 ? kMeanError : kChangesError}};
  if (reference.seeds > 0) {
    cell.expectations.push_back(lab::expect_mean(std::string(structure) + ".random_weights", "external",
                                                 reference.mean, reference.source()));
    cell.expectations.back().reference_error = reference.error;
    cell.min_seeds = kSeedsOfMeans;
  }
  catalogue.cells.push_back(std::move(cell));
}

void add_show_and_hide(lab::Catalogue& catalogue, int n, int m) {
  lab::Cell cell = lab::worst_case_cell("regular_2", "show-and-hide", n, 1, 0.1);
  cell.parameters.m = m;
  for (const char* kind : {"kind.show", "kind.hide"}) {
    cell.expectations.push_back(
        lab::expect_exactly(std::string("regular_2.show_and_hide.") + (kind + 5), kind,
                            Integer(2 * n * (m - 1)), "each point passes 2m - 2 circumcentres"));
  }
  cell.expectations.push_back(lab::expect_exactly("regular_2.show_and_hide", "external",
                                                  Integer(4 * n * (m - 1)),
                                                  "nothing else changes the triangulation"));
  catalogue.cells.push_back(std::move(cell));
}

}  // namespace

void add_weighted_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  add_small_weights(catalogue);
  for (const auto& [n, m] :
       {std::pair(2, 2), std::pair(2, 3), std::pair(8, 8), std::pair(16, 16)}) {
    add_show_and_hide(catalogue, n, m);
  }
  add_small_weights_in_space(catalogue);
  for (const int axes : {2, 3}) {
    const std::string structure = "regular_" + std::to_string(axes);
    for (const int k : {1, 4, 9}) {
      lab::Cell cell = lab::worst_case_cell(structure, "breathing", k, 1, 0.1);
      cell.parameters.dimension = axes;
      cell.expectations.push_back(lab::expect_exactly(
          structure + ".breathing", "external", Integer(k), "the point crosses the plane k times"));
      catalogue.cells.push_back(std::move(cell));
    }
    for (const int n : {16, 32, 64, 128}) {
      if (n > 32 && extent == lab::Extent::kQuick) continue;
      add_random(catalogue, structure.c_str(), axes, n);
    }
  }
}

}  // namespace kinex::families
